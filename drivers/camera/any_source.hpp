#pragma once

// Every kind of source that a cell file may name. It loads what OpenCV reads films and pictures with; image files that
// are JPEGs and PNGs alone do without (image_files.hpp).
//
//   VideoCamera eyes(executor, setup, make_any_source);

#include "drivers/camera/frame_source.hpp"

namespace pizarra {

std::unique_ptr<FrameSource> make_any_source(const CameraSource& source, const CameraSetup& setup);

}  // namespace pizarra
