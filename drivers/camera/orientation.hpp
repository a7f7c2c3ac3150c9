#pragma once

// The way up of a photograph, as cameras say it in Exif: the pixels lie as the sensor does.
//
//   const int orientation = orientation_in(exif);       // 1: as they lie
//   turn_upright(image, orientation);

#include <opencv2/core.hpp>
#include <span>

namespace pizarra::camera {

// `exif` begins as a TIFF. 1 where it says nothing.
int orientation_in(std::span<const unsigned char> exif);

void turn_upright(cv::Mat& image, int orientation);

}  // namespace pizarra::camera
