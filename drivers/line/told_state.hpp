#pragma once

// The state of a device that tells it unasked, many times a second: heard as it comes, and known while it is fresh.
//
//   ToldState told(line, 200ms);
//   ToldState::Hear hear = [this](const std::string& message) { return take(message); };
//   const Result<void> known = co_await told.listen(hear, 1s);       // over an open line
//   const bool on = co_await told.until(is_on, 20s);
//   if (!told.known()) co_return told.unknown();       // disconnected, and why
//
// Where the line fails, nothing is known any more until it is listened to anew. A message that is not sound is passed
// over: only when no sound one comes in time is the state unknown, and that one's failure says why.

#include <optional>

#include "drivers/line/dialogue.hpp"

namespace pizarra::line {

class ToldState {
 public:
  // Takes a message; whether it has told the state. Failure: it is not sound.
  using Hear = std::function<Result<bool>(const std::string& message)>;

  // The line outlives it.
  ToldState(Dialogue& line, Duration fresh) : line_(line), fresh_(fresh), told_(line.executor()) { forget(); }
  // Nothing is known, and nobody listens.
  void forget();
  // Answers once the state is known. Failure: disconnected; it is listened to all the same.
  Task<Result<void>> listen(Hear hear, Duration patience);

  bool known() const;
  // When the state was told last, where it is known.
  std::optional<Time> told_at() const { return told_at_; }
  std::unexpected<Failure> unknown() const { return fail("disconnected", why_unknown_); }
  // Looks whenever something was told. False where it has not come true in time.
  Task<bool> until(std::function<bool()> what, Duration patience);

 private:
  static constexpr Duration look_again = 3600s;
  Task<void> go_on_listening(Hear hear);
  std::string silent() const { return line_.device() + " does not tell its state"; }

  Dialogue& line_;
  Duration fresh_;
  std::optional<Time> told_at_;
  std::string why_unknown_;
  WaitList told_;
  Job listening_;
};

}  // namespace pizarra::line
