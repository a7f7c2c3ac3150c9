#include "drivers/simulation/controllers/arms/switched_wire.hpp"

namespace pizarra::simulation {

Task<Result<std::string>> SwitchedWire::read(Time deadline) {
  Result<std::string> bytes = co_await wire_.read(deadline);
  while (bytes) {
    if (powered_()) co_return bytes;
    bytes = co_await wire_.read(deadline);
  }
  co_return bytes;
}

}  // namespace pizarra::simulation
