#pragma once

// A connection or a serial line as lines of text, in both directions, each way with a bound.
//
//   Lines lines(executor, file);                                  // a file that does not block; it is closed here
//   const Result<std::string> line = co_await lines.next();       // without its end; empty ones are passed over
//   const bool open = co_await lines.room();
//   if (open) lines.say("(ok)");
//
// A line ends with LF, CR or both, and counts only when it has ended. Nothing more is read while a whole line waits to
// be heard, and nothing more should be said while there is no room: so the other side waits, and no queue grows. One at
// a time calls next(); several may wait for room. Both end before this is destroyed.

#include <optional>
#include <string>
#include <string_view>

#include "blackboard/time/latch.hpp"
#include "lisp/result.hpp"

namespace pizarra::door {

class Lines {
 public:
  static constexpr std::size_t longest = 4096;  // of a line, without its end
  static constexpr std::size_t most_unsent = 16 << 10;

  Lines(Executor& executor, int file);
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  ~Lines();

  // Failures: disconnected, timeout, too-long (the rest of that line is passed over), or what interrupt() was given.
  Task<Result<std::string>> next(std::optional<Time> deadline = {});
  // Until there is; false where next() fails at once.
  Task<bool> room();
  // One line, whether there is room or not.
  void say(std::string_view line);
  // What next() fails with, once.
  void interrupt(Failure why);
  // The other side has closed it, or it is broken.
  bool over() const { return broken_ || ended_; }
  // Says no more, and lets the other side read what was said: a socket that is closed with something unread takes that
  // back. At most a second.
  Task<void> finish();

 private:
  void run();
  void receive();
  void transmit();
  void look_for_more();
  std::optional<std::string> take_line();
  void pass_over_line();

  Executor& executor_;
  const int file_;
  const int poll_;  // readable whenever the file can be read or, where that is wanted, written
  unsigned wanted_ = 0;
  std::string unread_;
  std::string unsent_;
  std::optional<Failure> interrupted_;
  bool passing_over_ = false;  // what comes is the rest of a line that is too long
  bool throwing_away_ = false;
  bool ended_ = false;
  bool broken_ = false;
  WaitList changed_;
};

}  // namespace pizarra::door
