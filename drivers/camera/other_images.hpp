#pragma once

// Images that are neither JPEG nor PNG, by OpenCV (opencv_files.hpp). How large one is, is told by its first bytes:
// OpenCV makes room for it before it knows better.
//
//   Result<cv::Mat> image = read_other_image(bytes, grey);                 // of a BMP, PGM, PPM, TIFF or WebP
//   const std::optional<ImageSize> size = size_of_other_image(bytes);

#include <opencv2/core.hpp>
#include <optional>
#include <span>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {

// 8 bit; grey or BGR. Failures: corrupt-frame, in the words that follow a file's name; no-module.
Result<cv::Mat> read_other_image(std::span<const unsigned char> bytes, bool grey, ImageSize most = largest_pair);

// Nothing where the bytes are none of those, or end before they say.
std::optional<ImageSize> size_of_other_image(std::span<const unsigned char> bytes);

}  // namespace pizarra::camera
