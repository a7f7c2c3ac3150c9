#pragma once

// Work on a thread of its own that nobody waits for, not even in the end: a device may never answer. So it owns all
// that it touches; and the time that it is given goes on as that of who starts it, which may be gone.
//
//   start_detached(executor.now(), [desk](const std::function<Time()>& now) { read_for_ever(*desk, now); });

#include <functional>

#include "blackboard/time/clock.hpp"

namespace pizarra {

// `work` must not let an exception out.
void start_detached(Time now, std::function<void(const std::function<Time()>& now)> work);

}  // namespace pizarra
