#pragma once

// Image files of every format, camera devices and streams, and films that are written, by OpenCV. It brings two hundred
// libraries for them, which cost a tenth of a second and 70 MB. So they are loaded at the first call, and programs that
// call nothing here start without them.
//
//   const Result<OpencvFiles> opencv = opencv_files();
//   std::unique_ptr<cv::VideoCapture> capture(opencv->new_capture());
//   const Result<ImageBytes> png = encoded_image(".png", picture);
//
// The failure is no-module: the file `pizarra-opencv.so` is not beside the program, or cannot be loaded.

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::camera {

using ImageBytes = std::vector<std::uint8_t>;

// What the loaded file gives. All but the first two throw cv::Exception as OpenCV does.
struct OpencvFiles {
  cv::VideoCapture* (*new_capture)() = nullptr;  // the caller's
  cv::VideoWriter* (*new_writer)() = nullptr;    // the caller's
  cv::Mat (*decode)(const cv::_InputArray& bytes, bool grey) = nullptr;
  bool (*encode)(const std::string& ending, const cv::Mat& image, ImageBytes& bytes,
                 const std::vector<int>& settings) = nullptr;
};

Result<OpencvFiles> opencv_files();

// As a file of that ending, such as ".png"; the settings are cv::imencode's. Failure cannot-write: no format has that
// ending, or the image does not suit it.
Result<ImageBytes> encoded_image(const std::string& ending, const cv::Mat& image,
                                 const std::vector<int>& settings = {});

}  // namespace pizarra::camera
