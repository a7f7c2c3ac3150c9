#pragma once

// Whether a register that does one thing at a time could have given the answers that clients got. Each operation may
// take effect at any moment between its call and its answer.
//
//   std::vector<Operation> history = {{.kind = Operation::Kind::compare, .expected = 0, .value = 7, ...}, ...};
//   if (!is_linearizable(history)) ...
//
// A register begins with 0. Values that are written differ, so that an operation whose outcome nobody knows fits in one
// place at most, and the search stays small.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pizarra::bench {

struct Operation {
  enum class Kind { read, compare };
  enum class Outcome { done, refused, unknown };
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  // As `expected` of a compare that was refused: it could have been, whatever value stood there.
  static constexpr std::int64_t nothing = -1;

  Kind kind = Kind::read;
  Outcome outcome = Outcome::done;
  std::int64_t expected = 0;  // of a compare: puts `value` where this stands, and is refused elsewhere
  std::int64_t value = 0;     // of a read: what it was answered
  std::int64_t called = 0;
  std::int64_t answered = never;
};

bool is_linearizable(const std::vector<Operation>& history);
// A line an operation, in the order of the calls, with milliseconds since the first.
std::string describe(std::vector<Operation> history);

}  // namespace pizarra::bench
