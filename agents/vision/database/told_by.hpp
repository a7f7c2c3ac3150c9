#pragma once

// Every fact of the eyes begins with the name of the agent that tells it, for several may see one table:
//
//   told_by("left-eyes", form("(to-accept \"circle\" 1)"))    // (to-accept left-eyes "circle" 1)
//   any_told_by("left-eyes", "to-accept"_sym, 2)              // (to-accept left-eyes ? ?)
//   as_said(form("(to-accept left-eyes \"circle\" 1)"))       // (to-accept "circle" 1)

#include <string_view>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::vision {

// The same of a pattern.
inline Datum told_by(std::string_view agent, const Datum& fact) {
  std::vector<Datum> items(fact.items().begin(), fact.items().end());
  items.insert(items.begin() + 1, Datum::symbol(agent));
  return Datum::list(std::move(items));
}

// Any fact of a relation that has so many arguments besides the agent's name.
inline Datum any_told_by(std::string_view agent, Datum relation, std::size_t arguments) {
  std::vector<Datum> items(arguments + 1, "?"_sym);
  items.front() = std::move(relation);
  return told_by(agent, Datum::list(std::move(items)));
}

inline Datum as_said(const Datum& told) {
  std::vector<Datum> items(told.items().begin(), told.items().end());
  items.erase(items.begin() + 1);
  return Datum::list(std::move(items));
}

}  // namespace pizarra::vision
