#include "drivers/camera/frame_source.hpp"

#include <fmt/format.h>

#include "drivers/camera/capture_source.hpp"
#include "drivers/camera/image_files.hpp"

namespace pizarra {

std::unique_ptr<FrameSource> make_frame_source(const CameraSource& source, const CameraSetup& setup) {
  if (source.kind == CameraSource::Kind::images) {
    return std::make_unique<ImageFiles>(source.where, setup.rate_hz, setup.grey);
  }
  return std::make_unique<CaptureSource>(source, setup);
}

Result<cv::Mat> checked_image(cv::Mat image, const std::string& where) {
  if (image.empty()) return fail("corrupt-frame", fmt::format("{} is no image that can be read", where));
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    return fail("corrupt-frame", fmt::format("{} is neither a grey nor a colour image of 8 bits", where));
  }
  return image;
}

}  // namespace pizarra
