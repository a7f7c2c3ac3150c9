#include "drivers/camera/frame_source.hpp"

#include "drivers/camera/capture_source.hpp"
#include "drivers/camera/film_source.hpp"
#include "drivers/camera/image_files.hpp"

namespace pizarra::camera {

namespace {

std::unique_ptr<FrameSource> make_image_source(const forms::CameraSource& source, const forms::CameraSetup& setup) {
  const bool two = setup.arrangement == forms::CameraSetup::Arrangement::side_by_side;
  const ImageFiles::Reading reading{setup.rate_hz, setup.grey, two ? largest_pair : largest_image};
  if (setup.sources.size() < 2) return std::make_unique<ImageFiles>(source.where, reading);
  const std::array<std::string, 2> wheres{setup.sources[0].where, setup.sources[1].where};
  return std::make_unique<ImageFiles>(wheres, source == setup.sources[0] ? 0 : 1, reading);
}

std::unique_ptr<FrameSource> make_source(const forms::CameraSource& source, const forms::CameraSetup& setup) {
  switch (source.kind) {
    case forms::CameraSource::Kind::images:
      return make_image_source(source, setup);
    case forms::CameraSource::Kind::video:
      return std::make_unique<FilmSource>(source.where, setup.rate_hz);
    case forms::CameraSource::Kind::device:
    case forms::CameraSource::Kind::stream:
    case forms::CameraSource::Kind::pipeline:
      break;
  }
  return std::make_unique<CaptureSource>(source, setup);
}

}  // namespace

std::vector<std::unique_ptr<FrameSource>> sources_of(const forms::CameraSetup& setup) {
  std::vector<std::unique_ptr<FrameSource>> out;
  for (const forms::CameraSource& source : setup.sources) {
    out.push_back(make_source(source, setup));
  }
  return out;
}

}  // namespace pizarra::camera
