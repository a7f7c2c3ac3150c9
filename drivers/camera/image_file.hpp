#pragma once

// One image file. JPEGs and PNGs are read by their own libraries, and all else by OpenCV (other_images.hpp).
//
//   Result<cv::Mat> image = read_image_file("shots/1.jpg", grey);

#include <opencv2/core.hpp>
#include <string>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {

// 8 bit, grey or BGR, upright. Failure corrupt-frame, which names the file; of a larger one before it is decoded.
Result<cv::Mat> read_image_file(const std::string& file, bool grey, ImageSize most = largest_image);

}  // namespace pizarra::camera
