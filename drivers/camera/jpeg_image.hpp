#pragma once

// JPEGs, by libjpeg. What it warns of is a fault here: what is damaged it decodes all the same, what is missing grey.
// What damage leaves valid codes is none.
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
