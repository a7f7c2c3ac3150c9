#pragma once

// Work on a thread of its own that nobody waits for, not even at the program's end: a device may never answer. So the
// work must own all it touches. `now` goes on with its starter's time, and works when the starter's executor is gone.
//
//   start_detached(executor.now(), [desk](const std::function<Time()>& now) { read_for_ever(*desk, now); });

#include <functional>

#include "blackboard/time/clock.hpp"

namespace pizarra {

// `work` must not let an exception out.
void start_detached(Time now, std::function<void(const std::function<Time()>& now)> work);

}  // namespace pizarra
