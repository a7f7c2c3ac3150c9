#pragma once

// When steps and frames happen: both counted from the world's birth, so that a frame falls on a whole number of steps.
//
//   FrameClock clock(executor.now());
//   clock.steps_until(now);            // how many steps have their time by then
//   clock.next_frame(now, after);      // the number of the first frame that can still be taken

#include <cstdint>

#include "blackboard/time/clock.hpp"
#include "drivers/simulation/physics/physics.hpp"

namespace pizarra::simulation {

class FrameClock {
 public:
  static constexpr Duration frame_period = 100ms;
  static constexpr std::int64_t steps_per_frame = steps_per_second / 10;

  explicit FrameClock(Time now) : start_(now - now.time_since_epoch() % frame_period) {}
  std::int64_t steps_until(Time now) const { return (now - start_).count() * steps_per_second / 1'000'000; }
  Time frame_time(std::uint64_t frame) const { return start_ + frame_period * static_cast<std::int64_t>(frame); }
  std::int64_t frame_step(std::uint64_t frame) const { return static_cast<std::int64_t>(frame) * steps_per_frame; }
  // The first frame later than `after` that is not yet past. A time of another clock's counts as none.
  std::uint64_t next_frame(Time now, Time after) const {
    const auto passed = static_cast<std::uint64_t>((now - start_ + frame_period - Duration(1)) / frame_period);
    const std::uint64_t next = passed > 0 ? passed : 1;
    return frame_time(next) == after ? next + 1 : next;
  }

 private:
  Time start_;
};

}  // namespace pizarra::simulation
