#pragma once

// Frames whose every pixel says which frame it is of.

#include "blackboard/stream.hpp"

namespace pizarra::streams {

StreamFrame numbered_frame(std::uint64_t number, int width, int height, int channels = 1);
// Whether the frame is whole: no pixel is of another.
bool is_whole(const StreamFrame& frame);

}  // namespace pizarra::streams
