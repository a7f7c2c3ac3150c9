#pragma once

// Puts whoever answers messages at the device's end of a line of bytes: one client after another, what nobody takes is
// lost.
//
//   const Job serving = executor.spawn(serve_frames(executor, {.reader = frame_of_line, .answer = ...}, *port));

#include <functional>

#include "blackboard/time/executor.hpp"
#include "drivers/line/frames.hpp"

namespace pizarra::simulation {

struct FrameService {
  line::FrameReader reader;
  std::function<std::string()> greet = [] { return std::string(); };  // what a new client hears
  std::function<Task<std::string>(std::string)> answer = {};          // none, or empty: nothing is said
  std::function<bool(std::string_view)> last = {};  // whether it hangs up after the answer; never, where there is none
};

// Until destroyed. Executor and port outlive it.
Task<void> serve_frames(Executor& executor, FrameService service, line::ByteWire& port);

template <class Emulator>
Task<void> keep_telling(Executor& executor, Emulator& emulator, line::ByteWire& port) {
  while (true) {
    co_await sleep(executor, Emulator::told_every);
    if (!emulator.powered()) continue;
    const std::string state = co_await emulator.state();
    // What nobody takes is lost.
    static_cast<void>(port.write(state));
  }
}

// Of a controller with a port for its motion and one for its state, which it tells again and again. Until destroyed.
// All outlive them.
template <class Emulator>
Task<void> serve_motion(Executor& executor, Emulator& emulator, line::ByteWire& port) {
  FrameService service{.reader = emulator.frames()};
  service.answer = [&emulator](std::string message) { return emulator.answer(std::move(message)); };
  co_await serve_frames(executor, std::move(service), port);
}

template <class Emulator>
Task<void> serve_state(Executor& executor, Emulator& emulator, line::ByteWire& port) {
  const Job telling = executor.spawn(keep_telling(executor, emulator, port));
  FrameService service{.reader = emulator.frames()};
  co_await serve_frames(executor, std::move(service), port);
}

}  // namespace pizarra::simulation
