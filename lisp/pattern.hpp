#pragma once

// Patterns are data in which a symbol that begins with `?` is a variable; `?` alone matches anything and binds nothing.
//
//   Bindings bindings;
//   if (match(read_one("(on ?x ?y)").value(), fact, bindings)) bindings.find("?x");

#include <span>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra {

bool is_variable(const Datum& datum);
// Whether no variable stands anywhere in it.
bool is_ground(const Datum& datum);

// Variables to values, ordered by the variables' names, so that it prints the same everywhere.
class Bindings {
 public:
  struct Binding {
    Datum variable;  // a symbol, with its question mark
    Datum value;
    bool operator==(const Binding&) const = default;
  };

  const Datum* find(std::string_view variable) const;
  const Datum* find(const Datum& variable) const;
  // False when the variable is bound to something else already.
  bool bind(const Datum& variable, const Datum& value);
  bool bind(std::string_view variable, const Datum& value) { return bind(Datum::symbol(variable), value); }
  std::span<const Binding> all() const { return values_; }
  bool operator==(const Bindings&) const = default;

 private:
  friend bool match(const Datum& pattern, const Datum& datum, Bindings& bindings);
  bool extend(const Datum& pattern, const Datum& datum);

  std::vector<Binding> values_;
};

// Whether `datum` fits `pattern` under `bindings`, which then hold the new variables too; unchanged where it does not.
bool match(const Datum& pattern, const Datum& datum, Bindings& bindings);

// Whether it would fit if every variable stood for anything: quick, and never false for what fits.
bool resembles(const Datum& pattern, const Datum& datum);

// The pattern with every bound variable replaced.
Datum substitute(const Datum& pattern, const Bindings& bindings);

}  // namespace pizarra
