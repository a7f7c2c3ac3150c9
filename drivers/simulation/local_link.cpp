#include "drivers/simulation/link.hpp"
#include "drivers/simulation/world.hpp"

namespace pizarra::simulation {

Task<Result<Message>> LocalLink::call(Datum request, Duration) { return world_.handle(std::move(request)); }

Task<Result<Message>> NoLink::call(Datum, Duration) {
  co_return fail("disconnected", "there is no simulated world here");
}

}  // namespace pizarra::simulation
