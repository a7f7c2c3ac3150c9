#pragma once

// The commands of the prompt: name, what follows it, and what it does in one line.

#include <span>
#include <string_view>

#include "agents/repl/interpreter.hpp"
#include "lisp/reader.hpp"

namespace pizarra::repl {

struct Command {
  std::string_view name;
  std::string_view usage;
  std::string_view help;
  Task<Evaluation> (Interpreter::*run)(Datum form);
  static std::span<const Command> all();
};

// A pattern of ours, which can be read.
inline Datum read_pattern(std::string_view text) { return read_one(text).value(); }

}  // namespace pizarra::repl
