#include "drivers/camera/opencv_files.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>

namespace pizarra::camera {
namespace {

Result<OpencvFiles> load() {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path file = program.parent_path() / "pizarra-opencv.so";
  // Never unloaded: what it makes may live as long as the process.
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return fail("no-opencv", fmt::format("cannot load OpenCV's readers of files: {}", dlerror()));
  const void* const found = dlsym(handle, "pizarra_opencv_files");
  if (found == nullptr) return fail("no-opencv", fmt::format("{} is of another version", file.string()));
  return *static_cast<const OpencvFiles*>(found);
}

}  // namespace

Result<OpencvFiles> opencv_files() {
  static const Result<OpencvFiles> loaded = load();
  return loaded;
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
