#pragma once

// How long it is between a camera's frames, so that it can be said when one is missing. It goes by the slowest of late;
// a single long wait only doubles that.
//
//   FramePace pace;
//   pace.came(frame.captured);
//   pace.rest();                                   // what comes next says nothing of the time since
//   if (now - last > pace.patience()) ...          // none came for three frames' time

#include <algorithm>
#include <optional>

#include "blackboard/time/clock.hpp"

namespace pizarra::vision {

class FramePace {
 public:
  void came(Time captured) {
    if (last_) {
      const Duration between = captured - *last_;
      const bool first = period_ == Duration();
      period_ = first ? between : std::min(std::max(between, period_ * 7 / 8), period_ * 2);
    }
    last_ = captured;
  }
  void rest() { last_.reset(); }
  Duration patience() const { return period_ == Duration() ? unknown : std::max(least, 3 * period_); }

 private:
  static constexpr Duration unknown = 3s;
  static constexpr Duration least = 100ms;  // a machine may hold up that long who reads the camera

  std::optional<Time> last_;
  Duration period_{};
};

}  // namespace pizarra::vision
