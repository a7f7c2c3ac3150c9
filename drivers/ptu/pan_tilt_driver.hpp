#pragma once

// The interface of a pan-tilt agent to a unit's controller. Angles are degrees from the unit's middle; pan is positive
// to the right as the camera on it sees it, tilt is positive upwards.
//
// Lifecycle: connect(), which stops what moves and asks the unit for all that is known of it; then the others. After
// `disconnected`, `no-answer`, `bad-reply` or `restarted` nothing is known any more until connect() has succeeded
// again.
//
// Other failures: out-of-range (with the axis as subject), not-finite, refused (the unit's own words).
//
//   const Result<PanTiltRange> range = co_await unit.connect();
//   const Result<void> begun = co_await unit.move_to(PanTiltAxis::pan, 8);
//   const Result<PanTiltReading> now = co_await unit.read();         // until it moves no more

#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::ptu {

enum class PanTiltAxis : std::uint8_t { pan, tilt };

struct PanTiltAxisRange {
  double low_deg;
  double high_deg;
  double resolution_deg;
  double top_speed_deg_s;
};

struct PanTiltRange {
  PanTiltAxisRange pan;
  PanTiltAxisRange tilt;
};

struct PanTiltReading {
  double pan_deg;
  double tilt_deg;
  bool moving;
};

class PanTiltDriver {
 public:
  virtual ~PanTiltDriver() = default;
  virtual Task<Result<PanTiltRange>> connect() = 0;
  virtual void close() = 0;
  // Starts a move and answers once the unit has accepted it.
  virtual Task<Result<void>> move_to(PanTiltAxis axis, double deg) = 0;
  // `part` 0..1 of the top speed; the unit's slowest at 0.
  virtual Task<Result<void>> set_speed(PanTiltAxis axis, double part) = 0;
  virtual Task<Result<void>> halt() = 0;
  // Against the stops and to the middle, after which the unit knows where it is; answers when it stands there.
  virtual Task<Result<void>> reset(PanTiltAxis axis) = 0;
  virtual Task<Result<void>> reset_all() = 0;
  virtual Task<Result<PanTiltReading>> read() = 0;
};

}  // namespace pizarra::ptu
