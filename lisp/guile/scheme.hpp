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
// else, or raises an error, is a failure `scheme-error`. What people wrote wrongly our modules report as data:
//
//   Result<Source> source = read_source_file("cell.scm");
//   Result<Datum> cell = interpret(*source, "cell");

#include <expected>
#include <string>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra::guile {

Result<Datum> call_scheme(const std::string& module, const std::string& procedure, const std::vector<Datum>& arguments);

// A text that a person wrote, interpreted by one of our modules: normalised Datum or one report of all errors out.
//
// (pizarra MODULE) exports `interpret` (or another `procedure`). It gets the list of all data of the source, and the
// `more` arguments. It returns `(ok VALUE)` or `(errors ERROR ...)` (module_errors.hpp). (pizarra forms) does the
// plumbing: lisp/modules/pizarra/forms.scm.
//
// A failure has the first error's symbol, sentence and subject; its place holds every error in the order of the text,
// and the sentence then ends with "(and N more)".
Result<Datum> interpret(const Source& source, const std::string& module, const std::vector<Datum>& more = {},
                        const std::string& procedure = "interpret");

// The same of data that came without a text: a failure is the first error's, and has no place.
Result<Datum> interpret_data(const std::vector<Datum>& data, const std::string& module,
                             const std::vector<Datum>& more = {});

// The same with every error a failure of its own, in the order of the text; never empty.
std::expected<Datum, std::vector<Failure>> interpret_apart(const Source& source, const std::string& module,
                                                           const std::vector<Datum>& more = {},
                                                           const std::string& procedure = "interpret");

}  // namespace pizarra::guile
