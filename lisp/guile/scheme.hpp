#pragma once

// The embedded Guile: data in, data out. A Scheme value never leaves lisp/guile/.
//
// It starts at the first call and stays until the process ends. All calls must come from one thread, the first
// caller's; a call may come from inside a coroutine, since nothing of Guile's lives beyond the call. Modules are
// `(pizarra NAME)` in lisp/modules/pizarra/NAME.scm, compiled by CMake (see lisp/CMakeLists.txt for adding one).
//
//   Result<Datum> reply = call_scheme("vision-replies", "interpret", {list(read)});
//
// Symbols, strings, 64-bit integers, finite reals and proper lists pass both ways; a procedure that returns anything
// else, or raises an error, is a failure `scheme-error`: our modules report what people wrote wrongly as data instead,
// see interpret.hpp.

#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::guile {

Result<Datum> call_scheme(const std::string& module, const std::string& procedure, const std::vector<Datum>& arguments);

}  // namespace pizarra::guile
