#include "drivers/camera/opencv_files.hpp"

#include <fmt/format.h>

#include "drivers/camera/loaded_module.hpp"

namespace pizarra::camera {

Result<OpencvFiles> opencv_files() {
  static const Result<const void*> loaded = symbol_in_module("pizarra-opencv.so", "pizarra_opencv_files");
  if (!loaded) return fail(loaded);
  return *static_cast<const OpencvFiles*>(*loaded);
}

Result<ImageBytes> encoded_image(const std::string& ending, const cv::Mat& image, const std::vector<int>& settings) {
  const Result<OpencvFiles> opencv = opencv_files();
  if (!opencv) return fail(opencv);
  ImageBytes bytes;
  try {
    if (opencv->encode(ending, image, bytes, settings)) return bytes;
  } catch (const cv::Exception&) {
    // Of an ending that no format has.
  }
  return fail("cannot-write", fmt::format("an image cannot be written as {}", ending.empty() ? "it is named" : ending));
}

}  // namespace pizarra::camera
