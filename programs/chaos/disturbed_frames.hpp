#pragma once

// A frame of the world's camera as it comes while DeviceFaults says that something is wrong: dropped, late, frozen,
// doubled, covered, shifted, brighter or darker.
//
//   const Result<simulation::Message> frame = co_await ask_frame(world, request);      // (camera next ...)

#include "programs/chaos/device_line.hpp"

namespace pizarra::chaos {

// In the world's process. The world outlives it.
Task<Result<simulation::Message>> ask_frame(WorldProcess& world, Datum request);

}  // namespace pizarra::chaos
