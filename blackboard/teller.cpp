#include "blackboard/teller.hpp"

#include "blackboard/limits.hpp"

namespace pizarra {

Result<void> check_teller_name(std::string_view name) {
  if (name.size() > limits::name_bytes) {
    return fail("too-large", "the name of a teller has at most " + std::to_string(limits::name_bytes) + " bytes");
  }
  if (is_symbol_name(name) && name.front() != '?') return {};
  return fail(
      "bad-name",
      "a teller is called as a symbol is: letters a to z, digits, dashes and the like, without blanks, no digit and no "
      "question mark first",
      is_string_text(name) ? to_datum(name) : Datum());
}

}  // namespace pizarra
