#pragma once

// How many there were in the last whole second.
//
//   Rate rate;
//   rate.count(now);
//   rate.pass_to(now);
//   rate.last_second();

#include <cstdint>

#include "blackboard/time/clock.hpp"

namespace pizarra {

class Rate {
 public:
  void count(Time time) {
    pass_to(time);
    ++now_;
  }
  void pass_to(Time time) {
    const Time second = std::chrono::floor<std::chrono::seconds>(time);
    if (second == begun_) return;
    before_ = second == begun_ + std::chrono::seconds(1) ? now_ : 0;
    now_ = 0;
    begun_ = second;
  }
  // Of the time that was passed to.
  std::uint64_t last_second() const { return before_; }

 private:
  Time begun_{};
  std::uint64_t now_ = 0;
  std::uint64_t before_ = 0;
};

}  // namespace pizarra
