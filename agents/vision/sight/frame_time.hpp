#pragma once

// How long it is from one image to a later one, whatever the camera's rate.

#include <algorithm>

#include "blackboard/time/clock.hpp"

namespace pizarra::vision {

// Above 0 also where a camera's clock stands still: no camera is faster.
inline double seconds_between(Time before, Time after) {
  return std::max(0.001, std::chrono::duration<double>(after - before).count());
}

}  // namespace pizarra::vision
