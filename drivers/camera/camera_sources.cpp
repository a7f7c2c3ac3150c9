#include "drivers/camera/camera_sources.hpp"

#include "drivers/camera/capture_source.hpp"
#include "drivers/camera/image_files.hpp"

namespace pizarra::camera {

std::vector<std::unique_ptr<FrameSource>> sources_of(const forms::CameraSetup& setup) {
  std::vector<std::unique_ptr<FrameSource>> out;
  for (const forms::CameraSource& source : setup.sources) {
    if (source.kind == forms::CameraSource::Kind::images) {
      out.push_back(make_image_source(source, setup));
    } else {
      out.push_back(std::make_unique<CaptureSource>(source, setup));
    }
  }
  return out;
}

}  // namespace pizarra::camera
