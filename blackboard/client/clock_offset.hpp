#pragma once

// The other side's clock, estimated from the times that it told. The quickest answer gives the best estimate, because
// its time is known to within half of the round trip.
//
//   ClockOffset board;
//   board.heard(asked, executor.now(), said);
//   board.there(executor.now());              // nothing before it said anything

#include <optional>

#include "blackboard/time/clock.hpp"

namespace pizarra::client {

class ClockOffset {
 public:
  // Clocks drift apart.
  static constexpr Duration believed = 30s;

  void heard(Time asked, Time answered, Time said) {
    const Duration took = answered - asked;
    const bool better = !offset_ || took <= took_ || answered - measured_ > believed;
    if (!better) return;
    took_ = took;
    measured_ = answered;
    offset_ = said + took / 2 - answered;
  }
  std::optional<Time> there(Time here) const { return offset_ ? std::optional(here + *offset_) : std::nullopt; }
  void forget() { offset_.reset(); }

 private:
  std::optional<Duration> offset_;
  Duration took_{};
  Time measured_{};
};

}  // namespace pizarra::client
