#pragma once

// The one form of failure: a symbol for programs, a sentence for people, the subject it is about, and, where text was
// read, the place. It crosses the board as `(fail symbol "sentence" subject)`.
//
//   Result<Datum> goal = read_one(text);
//   if (!goal) return fail(goal);                       // pass it on
//   return fail("unknown-object", "nothing is called star", "star"_sym);

#include <expected>
#include <string>

#include "lisp/datum.hpp"

namespace pizarra {

struct Failure {
  std::string symbol;
  std::string sentence;
  Datum subject;
  // For text: "file:line:column", the line with a caret under it, and the context chain, one item a line; else empty.
  std::string place;

  bool operator==(const Failure&) const = default;
};

template <class T>
using Result = std::expected<T, Failure>;

inline std::unexpected<Failure> fail(std::string symbol, std::string sentence, Datum subject = {}) {
  return std::unexpected(Failure{std::move(symbol), std::move(sentence), std::move(subject), {}});
}

inline std::unexpected<Failure> fail(Failure failure) { return std::unexpected(std::move(failure)); }

template <class T>
std::unexpected<Failure> fail(const Result<T>& failed) {
  return std::unexpected(failed.error());
}

// `(fail symbol "sentence" subject)`, with the place as a fifth element where there is one, and back.
Datum failure_to_datum(const Failure& failure);
Failure failure_from_datum(const Datum& datum);

// What a person reads: the sentence, the subject if it says more, and the place below.
std::string describe(const Failure& failure);

}  // namespace pizarra
