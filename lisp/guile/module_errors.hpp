#pragma once

// The errors that a Scheme module finds in what a person wrote, `(symbol "sentence" (path ...) ("context" ...))`, at
// their places. A path leads from the top of the source to the wrong element. scheme.hpp has the modules' calls.
//
//   for (const Failure& wrong : failures_of(source, outcome->items().subspan(1))) report(wrong);

#include <span>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra::guile {

bool is_module_error(const Datum& error);

// Each of these errors, and of what the source could not read, in the order of the text.
std::vector<Failure> failures_of(const Source& source, std::span<const Datum> errors = {});

// One of data that came without a text: its subject is the wrong element, and it has no place.
Failure failure_of(std::span<const Datum> data, const Datum& error);

}  // namespace pizarra::guile
