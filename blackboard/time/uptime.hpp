#pragma once

// How long this machine has run since it was started, also while it was suspended. The time of an executor stands still
// during a suspend, so it cannot tell how old a promise is that another machine counts on.
//
//   const Duration sent = uptime();
//   ...
//   if (uptime() - sent < answers_for) ...

#include "blackboard/time/clock.hpp"

namespace pizarra {

Duration uptime();

}  // namespace pizarra
