#include "drivers/simulation/controllers/arms/serve_frames.hpp"

#include "drivers/simulation/controllers/serve.hpp"

namespace pizarra::simulation {

Task<void> serve_frames(Executor& executor, FrameService service, line::ByteWire& port) {
  line::Frames frames(port, service.reader);
  while (true) {
    frames.clear();
    const Time opened_by = executor.now() + opening_patience;
    const Result<void> open = co_await port.open(opened_by);
    if (!open) co_await sleep(executor, opening_pause);
    bool there = open.has_value();
    if (there) static_cast<void>(port.write(service.greet()));
    while (there) {
      const Time said_by = executor.now() + opening_patience;
      Result<std::string> message = co_await frames.next(said_by);
      if (!message) {
        there = message.error().symbol == "timeout";
        continue;
      }
      if (service.last) there = !service.last(*message);
      if (!service.answer) continue;
      const std::string said = co_await service.answer(std::move(*message));
      if (!said.empty()) static_cast<void>(port.write(said));
    }
    port.close();
  }
}

}  // namespace pizarra::simulation
