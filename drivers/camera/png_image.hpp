#pragma once

// PNGs, by libpng: of 1 to 16 bits, with a palette or without, interlaced or not; transparency is taken for none. Their
// check sums tell any damage.
//
//   if (is_png(bytes)) Result<cv::Mat> image = read_png(bytes, grey);

#include <opencv2/core.hpp>
#include <span>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {

bool is_png(std::span<const unsigned char> bytes);

// As the header says, which is the first 24 bytes.
ImageSize png_size(std::span<const unsigned char> bytes);

// Upright, 8 bit; grey or BGR. Failure corrupt-frame, in the words that follow a file's name.
Result<cv::Mat> read_png(std::span<const unsigned char> bytes, bool grey, ImageSize most = largest_pair);

}  // namespace pizarra::camera
