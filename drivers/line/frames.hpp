#pragma once

// The bytes of a line, cut into the messages of a protocol.
//
//   Frames frames(wire, frame_of_line);
//   const Result<std::string> line = co_await frames.next(deadline);      // without its end
//
// Failures: the wire's; bad-reply where no message can begin like that, or one would be longer than 64 KiB.

#include <optional>

#include "drivers/line/byte_wire.hpp"

namespace pizarra::line {

// The first message of what has come: all of its octets, and the part of them that says something.
struct Frame {
  std::size_t octets;
  std::string_view message;
};
// None where more must come first. Failure: bad-reply.
using FrameReader = Result<std::optional<Frame>> (*)(std::string_view octets);

class Frames {
 public:
  static constexpr std::size_t longest = 64 << 10;

  // The wire outlives it.
  Frames(ByteWire& wire, FrameReader reader) : wire_(wire), reader_(reader) {}
  Task<Result<std::string>> next(Time deadline);
  // Of a new connection.
  void clear() { unread_.clear(); }

 private:
  ByteWire& wire_;
  FrameReader reader_;
  std::string unread_;
};

// A line of text that ends with LF, CR or both; empty ones are passed over.
Result<std::optional<Frame>> frame_of_line(std::string_view octets);

}  // namespace pizarra::line
