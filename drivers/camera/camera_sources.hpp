#pragma once

// The sources of a cell file's (camera ...), not opened yet: one, or the left camera's and the right one's.
//
//   std::vector<std::unique_ptr<FrameSource>> sources = sources_of(description.eyes);

#include <vector>

#include "drivers/camera/frame_source.hpp"

namespace pizarra::camera {

std::vector<std::unique_ptr<FrameSource>> sources_of(const forms::CameraSetup& setup);

}  // namespace pizarra::camera
