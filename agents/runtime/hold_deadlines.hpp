#pragma once

// A motion that lasts only while a client holds on stops when the client's last hold is older than a deadline. The
// client names the deadline with the motion; the robot's agent takes it within these bounds.
//
//   const Duration deadline = std::clamp<Duration>(wanted, least_hold_deadline, longest_hold_deadline);

#include "blackboard/time/clock.hpp"

namespace pizarra::runtime {

// A busy page needs the shorter one. A person would not bear a longer one.
inline constexpr Duration least_hold_deadline = 250ms;
inline constexpr Duration longest_hold_deadline = 600ms;

}  // namespace pizarra::runtime
