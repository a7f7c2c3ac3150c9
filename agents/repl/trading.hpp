#pragma once

// Trading: an agent by its kind and its properties, as (find robot (reach > 600) (host ?)) asks for them.
//
//   Result<std::vector<Wish>> wishes = wishes_from(form);       // (NAME ?), (NAME OP VALUE); OP > >= < <= = /=
//   std::optional<std::string> met = met_by(*wishes, {{"reach", to_datum(710)}, {"host", to_datum("bench")}});

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::repl {

struct Wish {
  std::string name;
  std::string compare;  // empty: whatever it is
  Datum value;
};

// Failure malformed.
Result<std::vector<Wish>> wishes_from(const Datum& form);

// "reach 710, host bench" where the properties meet every wish; nothing where one is missing or differs. Only numbers
// are compared as greater or less.
std::optional<std::string> met_by(const std::vector<Wish>& wishes, const std::map<std::string, Datum>& properties);

}  // namespace pizarra::repl
