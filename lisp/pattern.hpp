#pragma once

// Patterns are data in which a symbol that begins with `?` is a variable; `?` alone matches anything and binds nothing.
//
//   Bindings bindings;
//   if (match(read_one("(on ?x ?y)").value(), fact, bindings)) bindings.find("?x");

#include <map>
#include <string>

#include "lisp/datum.hpp"

namespace pizarra {

bool is_variable(const Datum& datum);
// Whether no variable stands anywhere in it.
bool is_ground(const Datum& datum);

// Variable names, with their question mark, to values; ordered, so that it prints the same everywhere.
class Bindings {
 public:
  const Datum* find(std::string_view variable) const;
  // False when the variable is bound to something else already.
  bool bind(std::string_view variable, const Datum& value);
  const std::map<std::string, Datum, std::less<>>& all() const { return values_; }
  bool operator==(const Bindings&) const = default;

 private:
  std::map<std::string, Datum, std::less<>> values_;
};

// Whether `datum` fits `pattern` under `bindings`, which then hold the new variables too; unchanged where it does not.
bool match(const Datum& pattern, const Datum& datum, Bindings& bindings);

// The pattern with every bound variable replaced.
Datum substitute(const Datum& pattern, const Bindings& bindings);

}  // namespace pizarra
