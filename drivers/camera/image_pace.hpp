#pragma once

// When the next image is due. Recordings are waited for; of a camera that is faster than it was asked to be, images are
// let go.
//
//   ImagePace pace(30, now);                     // 0: as they come
//   wait(pace.until_due(now));                   // before an image of a recording is read
//   if (pace.is_due(now)) pace.taken(now);       // else the image is let go

#include <algorithm>

#include "blackboard/time/clock.hpp"

namespace pizarra::camera {

class ImagePace {
 public:
  ImagePace(double rate_hz, Time now) : next_(now) {
    if (rate_hz > 0) period_ = Duration(static_cast<std::int64_t>(1e6 / rate_hz));
  }
  Duration until_due(Time now) const { return next_ - now; }
  // A camera's own rate is never quite what it is said to be.
  bool is_due(Time now) const { return next_ - now < period_ / 4; }
  // Who is late begins anew.
  void taken(Time now) { next_ = std::max(next_ + period_, now); }

 private:
  Duration period_{};
  Time next_;
};

}  // namespace pizarra::camera
