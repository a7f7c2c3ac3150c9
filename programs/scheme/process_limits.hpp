#pragma once

// The limits on what a process may take from its machine: memory, files, processes. Against a program within it that
// gets round the interpreter's own limits.
//
//   Result<void> limited = limit_process(64);      // once its threads run and its files are open
//
// A process that asks for more memory than that ends; its supervisor starts it again.

#include "lisp/result.hpp"

namespace pizarra::programs {

// `memory_mb`: what the program in it may take, some of which may be garbage. Failure: no-limits.
Result<void> limit_process(int memory_mb);

}  // namespace pizarra::programs
