#include "drivers/camera/frame_source.hpp"

#include <fmt/format.h>

#include "drivers/camera/capture_source.hpp"
#include "drivers/camera/image_files.hpp"

namespace pizarra {

std::unique_ptr<FrameSource> make_frame_source(const CameraSource& source, const CameraSetup& setup) {
  const bool images = source.kind == CameraSource::Kind::images;
  if (images && setup.sources.size() == 2) {
    const std::size_t side = source == setup.sources[0] ? 0 : 1;
    const std::array<std::string, 2> wheres{setup.sources[0].where, setup.sources[1].where};
    return std::make_unique<ImageFiles>(wheres, side, setup.rate_hz, setup.grey);
  }
  if (images) {
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
