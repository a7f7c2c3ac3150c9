#pragma once

// How many messages a second somebody may send: at once as many as a second allows, then no faster.
//
//   Allowance allowance(1000);
//   co_await sleep(executor, allowance.take(steps, executor.now()));

#include <algorithm>

#include "blackboard/time/clock.hpp"

namespace pizarra::scheme {

class Allowance {
 public:
  explicit Allowance(double per_second) : each_us_(1e6 / per_second) {}

  // Takes so many, and answers how long to wait before they are sent.
  Duration take(std::size_t messages, Time now) {
    const Duration cost(static_cast<Duration::rep>(each_us_ * static_cast<double>(messages)));
    spent_until_ = std::max(spent_until_, now) + cost;
    return std::max(Duration(0), spent_until_ - now - Duration(std::chrono::seconds(1)));
  }

 private:
  double each_us_;
  Time spent_until_{};
};

}  // namespace pizarra::scheme
