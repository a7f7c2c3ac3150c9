#pragma once

// Beats at a steady rate, whatever the work between them takes; what was missed by more than a beat is left out.
//
//   Pace pace(executor, 8ms);
//   while (true) {
//     const Duration pause = pace.pause();
//     co_await sleep(executor, pause);
//     ...
//   }

#include <algorithm>

#include "blackboard/time/executor.hpp"

namespace pizarra {

class Pace {
 public:
  Pace(const Executor& executor, Duration period) : executor_(executor), period_(period), next_(executor.now()) {}
  // From now to the next beat.
  Duration pause() {
    next_ = std::max(next_ + period_, executor_.now() - period_);
    return std::max(next_ - executor_.now(), Duration::zero());
  }

 private:
  const Executor& executor_;
  const Duration period_;
  Time next_;
};

}  // namespace pizarra
