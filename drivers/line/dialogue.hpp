#pragma once

// A line of bytes over which a device answers questions, one at a time; who comes meanwhile waits.
//
//   Dialogue dashboard(executor, wire, frame_of_line, "the dashboard server");
//   const Result<void> open = co_await dashboard.open(deadline);
//   const Result<std::string> answer = co_await dashboard.ask("robotmode\n");
//
// Messages that do not answer the question are passed over. Failure of ask(): disconnected, also of a device that does
// not answer for a second.

#include <functional>

#include "blackboard/time/turns.hpp"
#include "drivers/line/device_at.hpp"
#include "drivers/line/frames.hpp"

namespace pizarra::line {

class Dialogue {
 public:
  using Fits = std::function<bool(const std::string& message)>;
  static constexpr Duration answer_time = 1s;

  // The wire outlives it.
  Dialogue(Executor& executor, ByteWire& wire, FrameReader reader, std::string device)
      : executor_(executor),
        wire_(wire),
        frames_(wire, reader),
        device_(device_at(std::move(device), wire.place())),
        turns_(executor) {}
  Task<Result<void>> open(Time deadline);
  Result<void> say(std::string_view octets) { return wire_.write(octets); }
  // What comes next; where nobody asks.
  Task<Result<std::string>> next(Time deadline) { return frames_.next(deadline); }
  // The first message that fits; any.
  Task<Result<std::string>> ask(std::string question, Fits fits);
  Task<Result<std::string>> ask(std::string question) {
    return ask(std::move(question), [](const std::string&) { return true; });
  }
  // The same of what cannot wait: it is said before those who ask have had their answers, and its own comes after
  // theirs.
  Task<Result<std::string>> ask_at_once(std::string question, Fits fits);

  Executor& executor() const { return executor_; }
  const std::string& device() const { return device_; }

 private:
  Task<Result<std::string>> answer(Fits fits);

  Executor& executor_;
  ByteWire& wire_;
  Frames frames_;
  const std::string device_;
  Turns turns_;
};

}  // namespace pizarra::line
