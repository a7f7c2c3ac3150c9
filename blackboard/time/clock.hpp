#pragma once

// Time as agents see it: microseconds since the epoch, real or virtual. Only an Executor knows what time it is.
//
//   const Time deadline = executor.now() + 500ms;

#include <chrono>

namespace pizarra {

using Duration = std::chrono::microseconds;
using Time = std::chrono::sys_time<Duration>;

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using std::chrono_literals::operator""us;

}  // namespace pizarra
