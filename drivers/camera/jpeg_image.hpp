#pragma once

// JPEGs, by libjpeg. The library only warns of damage and decodes all the same, with grey where octets are missing.
// Here a warning is a fault. Damage that leaves valid codes is not noticed.
//
//   if (is_jpeg(bytes)) Result<cv::Mat> image = read_jpeg(bytes, grey);

#include <opencv2/core.hpp>
#include <span>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {

bool is_jpeg(std::span<const unsigned char> bytes);

// Each goes over the whole image, and of a progressive JPEG's thousands a few hundred bytes each may tell nothing. What
// encoders make has about ten.
inline constexpr int most_scans = 32;

// Upright; grey, for which no colour is decoded, or BGR. Failure corrupt-frame, in the words that follow a file's name.
Result<cv::Mat> read_jpeg(std::span<const unsigned char> bytes, bool grey, ImageSize most = largest_pair);

}  // namespace pizarra::camera
