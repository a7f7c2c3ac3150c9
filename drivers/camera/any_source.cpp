#include "drivers/camera/any_source.hpp"

#include "drivers/camera/capture_source.hpp"
#include "drivers/camera/image_files.hpp"
#include "drivers/camera/other_images.hpp"

namespace pizarra::camera {

std::unique_ptr<FrameSource> make_any_source(const forms::CameraSource& source, const forms::CameraSetup& setup) {
  if (source.kind == forms::CameraSource::Kind::images) return make_image_source(source, setup, read_other_image);
  return std::make_unique<CaptureSource>(source, setup);
}

}  // namespace pizarra::camera
