#include "agents/robot/motion_watch.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/time/pace.hpp"

namespace pizarra::robot {

Task<Result<arm::ArmReading>> MotionWatch::until_ended(Of what, Duration longest) {
  const bool gripper = what == Of::gripper;
  const Time begun = executor_.now();
  Time heard = begun;
  Pace pace(executor_, std::min(poll_period, tell_period_ / 2));
  begin();
  while (true) {
    const Duration pause = pace.pause();
    co_await sleep(executor_, pause);
    const Result<arm::ArmReading> reading = co_await arm_.read();
    const Time now = executor_.now();
    if (!reading) {
      if (now - heard < patience) continue;
      arm_.lose(reading.error());
      co_return fail(reading);
    }
    const bool unknown = gripper && reading->gripper_trouble;
    if (unknown && now - heard < patience) continue;
    if (unknown) co_return fail(*reading->gripper_trouble);
    heard = now;
    const bool moving = gripper ? reading->gripper_moving : reading->moving;
    if (!moving) co_return reading;
    if (now - begun > longest) {
      const Result<void> halting = co_await arm_.brake();
      if (!halting) arm_.lose(halting.error());
      co_return fail("fault", fmt::format("the motion did not end within {:.1f} s", longest.count() / 1e6));
    }
    tell_where_due();
  }
}

void MotionWatch::tell_where_due() {
  const Time now = executor_.now();
  if (now < tell_at_ || !facts_.changed()) return;
  tell_at_ = std::max(tell_at_ + tell_period_, now);
  // A board that is slow is told the newest when it is back, and the looking at the arm does not wait for it.
  if (!telling_) on_the_way_ = executor_.spawn(tell());
}

// A board that is away misses this; the end of the motion is told surely.
Task<void> MotionWatch::tell() {
  telling_ = true;
  const Result<void> told = co_await facts_.tell();
  if (!told) facts_.forget_told();
  telling_ = false;
}

}  // namespace pizarra::robot
