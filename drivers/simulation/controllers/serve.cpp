#include "drivers/simulation/controllers/serve.hpp"

namespace pizarra::simulation {

namespace {

struct Plugged {
  Plugged(PtuEmulator& the_unit, line::ByteWire& wire) : unit(the_unit) {
    // What nobody takes is lost, as on any line.
    unit.on_say([&wire](std::string_view bytes) { static_cast<void>(wire.write(bytes)); });
  }
  Plugged(const Plugged&) = delete;
  Plugged& operator=(const Plugged&) = delete;
  ~Plugged() { unit.on_say(nullptr); }
  PtuEmulator& unit;
};

}  // namespace

Task<void> serve(Executor& executor, PtuEmulator& unit, line::ByteWire& wire) {
  const Plugged plugged(unit, wire);
  while (true) {
    const Time opened_by = executor.now() + opening_patience;
    const Result<void> open = co_await wire.open(opened_by);
    if (!open) co_await sleep(executor, opening_pause);
    Result<std::string> bytes;
    while (bytes) {
      const Time said_by = executor.now() + opening_patience;
      bytes = co_await wire.read(said_by);
      if (bytes) unit.receive(*bytes);
      const bool idle = !bytes && bytes.error().symbol == "timeout";
      if (idle) bytes = Result<std::string>();
    }
  }
}

}  // namespace pizarra::simulation
