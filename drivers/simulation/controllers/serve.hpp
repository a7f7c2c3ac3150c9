#pragma once

// Puts an emulated controller at one end of a wire: whoever opens the other end drives it, one after another.
//
//   const Job serving = executor.spawn(serve(executor, unit, *port));

#include "drivers/line/byte_wire.hpp"
#include "drivers/simulation/controllers/ptu_emulator.hpp"

namespace pizarra::simulation {

// How long an emulated controller waits for its end of a line to open, and how long before it tries anew.
inline constexpr Duration opening_patience = 3600s;
inline constexpr Duration opening_pause = 100ms;

// Until destroyed. All three outlive it.
Task<void> serve(Executor& executor, PtuEmulator& unit, line::ByteWire& wire);

}  // namespace pizarra::simulation
