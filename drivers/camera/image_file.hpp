#pragma once

// One image file. JPEGs and PNGs are read here; what else there may be, by who loads more for it (other_images.hpp).
//
//   Result<cv::Mat> image = read_image_file("shots/1.jpg", grey, read_other_image);

#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {

// Reads what is neither JPEG nor PNG; null: nobody does.
using OtherImages = Result<cv::Mat> (*)(std::span<const unsigned char> bytes, bool grey, ImageSize most);

// 8 bit, grey or BGR, upright. Failure corrupt-frame, which names the file; of a larger one before it is decoded.
Result<cv::Mat> read_image_file(const std::string& file, bool grey, OtherImages others, ImageSize most = largest_image);

// By its first bytes, whatever it is called.
bool is_jpeg_or_png_file(const std::string& file);

}  // namespace pizarra::camera
