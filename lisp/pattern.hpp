#pragma once

// Patterns are data in which a symbol that begins with `?` is a variable; `?` alone matches anything and binds nothing.
//
//   Bindings bindings;
//   if (match(read_one("(on ?x ?y)").value(), fact, bindings)) bindings.find("?x");

#include <optional>
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
  friend class FlatPattern;
  friend bool match(const Datum& pattern, const Datum& datum, Bindings& bindings);
  bool extend(const Datum& pattern, const Datum& datum);

  std::vector<Binding> values_;
};

// Whether `datum` fits `pattern` under `bindings`, which then hold the new variables too; unchanged where it does not.
bool match(const Datum& pattern, const Datum& datum, Bindings& bindings);

// A pattern of which every element is ground or a variable, none of them twice: where they stand is found once, so that
// many data are matched sooner.
//
//   const std::optional<FlatPattern> pattern = FlatPattern::of(read_one("(seen ?name ?x)").value());
//   std::optional<Bindings> bindings = pattern->match(fact);
class FlatPattern {
 public:
  // Nothing where it is another.
  static std::optional<FlatPattern> of(const Datum& pattern);
  // What match() would bind; nothing where the datum does not fit.
  std::optional<Bindings> match(const Datum& datum) const;

 private:
  struct Element {
    Datum datum;
    std::size_t place;
  };
  std::size_t size_ = 0;
  std::vector<Element> ground_;
  std::vector<Element> variables_;  // by name
};

// Whether it would fit if every variable stood for anything: quick, and never false for what fits.
bool resembles(const Datum& pattern, const Datum& datum);

// The pattern with every bound variable replaced.
Datum substitute(const Datum& pattern, const Bindings& bindings);

}  // namespace pizarra
