#pragma once

// Puts an emulated controller at one end of a wire: whoever opens the other end drives it, one after another.
//
//   const Job serving = executor.spawn(serve(executor, unit, *port));

#include "drivers/simulation/controllers/ptu_emulator.hpp"
#include "drivers/line/byte_wire.hpp"

namespace pizarra {

// Until destroyed. All three outlive it.
Task<void> serve(Executor& executor, PtuEmulator& unit, ByteWire& wire);

}  // namespace pizarra
