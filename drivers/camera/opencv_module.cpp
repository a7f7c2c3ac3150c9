// The file `pizarra-opencv.so`, which opencv_files.cpp loads. It alone links what OpenCV reads and writes files with.

#include <opencv2/imgcodecs.hpp>

#include "drivers/camera/opencv_files.hpp"

extern "C" const pizarra::camera::OpencvFiles pizarra_opencv_files = {
    .new_capture = [] { return new cv::VideoCapture; },
    .new_writer = [] { return new cv::VideoWriter; },
    .decode = [](const cv::_InputArray& bytes,
                 bool grey) { return cv::imdecode(bytes, grey ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR); },
    .encode = [](const std::string& ending, const cv::Mat& image, pizarra::camera::ImageBytes& bytes,
                 const std::vector<int>& settings) { return cv::imencode(ending, image, bytes, settings); }};
