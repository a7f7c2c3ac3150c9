#include <utility>

#include "blackboard/time/pace.hpp"
#include "drivers/simulation/controllers/arms/serve_frames.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"

// The controller's servers, each at a port of its own.
namespace pizarra::simulation {

namespace {

constexpr std::size_t longest_program = 1 << 20;
constexpr Duration client_pause = 10ms;  // until it is looked again for one that wants to be told

Task<std::string> nothing() { co_return std::string(); }

Task<std::string> answer_line(UrEmulator& emulator, std::string line) {
  std::string answer = co_await emulator.dashboard(std::move(line));
  co_return answer + "\n";
}

Task<void> tell_states(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  std::optional<Pace> pace;
  std::optional<Duration> paced;
  while (true) {
    const std::optional<Duration> every = emulator.told_every();
    // Another client may want it at another rate.
    if (every != paced) pace.reset();
    paced = every;
    if (!every) {
      co_await sleep(executor, client_pause);
      continue;
    }
    if (!pace) pace.emplace(executor, *every);
    const Duration pause = pace->pause();
    co_await sleep(executor, pause);
    const UrState state = co_await emulator.state();
    // Nobody reads, or it has no power: what is not told is lost. It may have been paused meanwhile.
    if (emulator.told_every()) static_cast<void>(port.write(emulator.tell(state)));
  }
}

}  // namespace

Task<void> serve_rtde(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  const Job telling = executor.spawn(tell_states(executor, emulator, port));
  FrameService service{.reader = arm::rtde::frame};
  service.greet = [&emulator] {
    emulator.forget_client();
    return std::string();
  };
  service.answer = [&emulator](std::string message) { return emulator.answer(std::move(message)); };
  co_await serve_frames(executor, std::move(service), port);
}

namespace {

// Tells what an interface tells, to whoever has come last.
Task<void> tell_interface(Executor& executor, UrEmulator& emulator, UrInterface kind, bool& heard,
                          line::ByteWire& port) {
  constexpr Duration real_time = 2ms;
  constexpr Duration others = 10ms;
  constexpr int states_apart = 10;
  Pace pace(executor, kind == UrInterface::real_time ? real_time : others);
  for (int beat = 0;; beat = (beat + 1) % states_apart) {
    const Duration pause = pace.pause();
    co_await sleep(executor, pause);
    if (!heard || !emulator.powered()) continue;
    std::string said;
    if (kind == UrInterface::primary) said = emulator.take_said();
    if (kind == UrInterface::real_time || beat == 0) {
      const UrState state = co_await emulator.state();
      said += kind == UrInterface::real_time ? ur_real_time_packet(state) : ur_state_message(emulator.model(), state);
    }
    if (said.empty()) continue;
    const bool told = port.write(said).has_value();
    // Who reads too slowly is there all the same.
    heard = told || port.write({}).has_value();
  }
}

}  // namespace

// A program of several lines ends with the line `end`.
Task<void> serve_interface(Executor& executor, UrEmulator& emulator, UrInterface kind, line::ByteWire& port) {
  bool heard = false;
  const Job telling = executor.spawn(tell_interface(executor, emulator, kind, heard, port));
  std::string program;
  FrameService service{.reader = line::frame_of_line};
  service.greet = [&] {
    program.clear();
    heard = true;
    if (kind == UrInterface::primary) static_cast<void>(emulator.take_said());
    return kind == UrInterface::real_time ? std::string() : ur_version_message(emulator.now_us());
  };
  service.answer = [&](std::string line) {
    const bool begins = line.starts_with("def ") || line.starts_with("sec ");
    const bool within = begins || !program.empty();
    program += line + "\n";
    if (!within || line == "end") emulator.run(std::exchange(program, {}));
    if (program.size() > longest_program) program.clear();
    return nothing();
  };
  co_await serve_frames(executor, std::move(service), port);
}

Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  FrameService service{.reader = line::frame_of_line};
  service.greet = [] { return std::string("Connected: Universal Robots Dashboard Server\n"); };
  service.answer = [&emulator](std::string line) { return answer_line(emulator, std::move(line)); };
  service.last = [](std::string_view line) { return line == "quit"; };
  co_await serve_frames(executor, std::move(service), port);
}

}  // namespace pizarra::simulation
