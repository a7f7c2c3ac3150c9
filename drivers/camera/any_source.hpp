#pragma once

// Every kind of source that a cell file may name. It loads what OpenCV reads films and pictures with; image files that
// are JPEGs and PNGs alone do without (image_files.hpp).
//
//   VideoCamera eyes(executor, setup, make_any_source);

#include "drivers/camera/frame_source.hpp"

namespace pizarra::camera {

std::unique_ptr<FrameSource> make_any_source(const forms::CameraSource& source, const forms::CameraSetup& setup);

}  // namespace pizarra::camera
