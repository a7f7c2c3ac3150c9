#pragma once

// When steps and frames happen: both counted from the world's birth, so that a frame falls on a whole number of steps.
//
//   FrameClock clock(executor.now(), 30);
//   clock.steps_until(now);            // how many steps have their time by then
//   clock.next_frame(now, after);      // the number of the first frame that can still be taken

#include <algorithm>
#include <cstdint>

#include "blackboard/time/clock.hpp"
#include "drivers/simulation/physics/physics.hpp"

namespace pizarra::simulation {

class FrameClock {
 public:
  // Whether so many frames a second fall on whole steps, and on the clock's tenths of a second.
  static bool keeps(int frames_per_s) {
    return frames_per_s > 0 && steps_per_second % frames_per_s == 0 && frames_per_s % 10 == 0;
  }

  FrameClock(Time now, int frames_per_s)
      : start_(now - now.time_since_epoch() % Duration(100'000)), frames_per_s_(frames_per_s) {}
  std::int64_t steps_per_frame() const { return steps_per_second / frames_per_s_; }
  std::int64_t steps_until(Time now) const { return (now - start_).count() * steps_per_second / us_per_second; }
  // The first whole microsecond by which its step has its time.
  Time frame_time(std::uint64_t frame) const {
    const auto number = static_cast<std::int64_t>(frame);
    return start_ + Duration((number * us_per_second + frames_per_s_ - 1) / frames_per_s_);
  }
  std::int64_t frame_step(std::uint64_t frame) const { return static_cast<std::int64_t>(frame) * steps_per_frame(); }
  // The first frame later than `after` that is not yet past. A time of another clock's counts as none.
  std::uint64_t next_frame(Time now, Time after) const {
    const std::int64_t past = std::max<std::int64_t>(0, (now - start_).count() - 1) * frames_per_s_ / us_per_second;
    const auto next = static_cast<std::uint64_t>(past + 1);
    return frame_time(next) == after ? next + 1 : next;
  }

 private:
  static constexpr std::int64_t us_per_second = 1'000'000;

  Time start_;
  int frames_per_s_;
};

}  // namespace pizarra::simulation
