#pragma once

// A text that a person wrote, interpreted by one of our Scheme modules: text in, normalised Datum or one report of all
// errors out.
//
// `(pizarra MODULE)` exports `interpret` (or another `procedure`). It gets the list of all data of the source, and the
// `more` arguments. It returns `(ok VALUE)` or `(errors (symbol "sentence" (path ...) ("context" ...)) ...)`. A path
// leads from the top of the source to the wrong element. (pizarra forms) does the plumbing:
// lisp/modules/pizarra/forms.scm.
//
//   Result<Source> source = read_source_file("cell.scm");
//   Result<Datum> cell = interpret(*source, "cell");
//
// To add a module: write lisp/modules/pizarra/NAME.scm and NAME-test.scm beside it, and name it in the list of
// lisp/CMakeLists.txt.

#include <expected>
#include <span>
#include <string>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra::guile {

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

// Each of the errors `(symbol "sentence" (path ...) ("context" ...))`, and of what the source could not read.
std::vector<Failure> failures_of(const Source& source, std::span<const Datum> errors = {});

}  // namespace pizarra::guile
