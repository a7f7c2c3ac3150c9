#pragma once

// The names that a client of a board may have. Agents speak of who asked them by that name, as a symbol in facts and
// failures: so it is one, and no variable, which would mean everybody.
//
//   Result<void> named = check_teller_name("my script");         // bad-name

#include <string_view>

#include "lisp/result.hpp"

namespace pizarra {

// Failures `bad-name` and, beyond limits::name_bytes, `too-large`.
Result<void> check_teller_name(std::string_view name);

}  // namespace pizarra
