#pragma once

// The first questions to an arm's controller, and to one that was away: is it the controller of this arm? Does the arm
// move although no client asked for it? At most controllers a motion goes on when the client that began it is gone.
// Such a motion is stopped here, for every driver alike. An arm whose controller does not say whether it moves is
// stopped as well. An arm that somebody moves by the pendant is left alone.
//
//   const Result<ArmMeeting> met = co_await meet_arm(executor, driver, model);
//
// Most controllers do not say of which arm they are (see the drivers). An arm that stands where one of the file cannot
// is either another or one that somebody must bring back: it is stopped, and commanded no further.
//
// Failures: unknown-arm, where the controller is of another, which is then let alone; joint-limit, where it stands
// beyond the file's limits; fault, where the arm does not come to rest; the driver's own.

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"

namespace pizarra::arm {

// At most, until a stopped arm stands.
inline constexpr Duration stopping_time = 5s;

// It moves, and nobody at the pendant moves it.
bool moves_for_nobody(const ArmReading& reading);

struct ArmMeeting {
  ArmReading reading;
  bool was_stopped;  // it moved, and does not any more
};

// The executor and the driver outlive it.
Task<Result<ArmMeeting>> meet_arm(Executor& executor, ArmDriver& driver, const ArmModel& model);

}  // namespace pizarra::arm
