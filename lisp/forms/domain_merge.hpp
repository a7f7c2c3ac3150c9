#pragma once

// The form of a domain that extends another one, merged with the other's form.
//
// The extending domain's words about a name replace all that the other says of this name: of a type, a predicate, an
// object, the facts of a predicate, an operator, a constant, what is seen, the rules of a predicate, a micro-task.
// Parts that the other does not name are added: before the next name that is replaced, or else at the end, so that
// rules and micro-tasks keep the order in which they are written. Names that are to be left out go with all that the
// other says of them, and with what its operators do to them.
//
//   const Piece merged = merge_domains(own, other, {"stack"});     // without the other's operator `stack`

#include <set>
#include <string>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra::forms {

// A datum with the place where it was written.
struct Piece {
  Datum datum;
  Spot spot;
};

std::vector<Piece> pieces_of(const Piece& list);

// `own` and `other` are forms (domain NAME SECTION ...). Sections and entries that are malformed stay, for those who
// check them.
Piece merge_domains(const Piece& own, const Piece& other, const std::set<std::string>& left_out);

// Every name that the form says something of.
std::set<std::string> names_said(const Piece& domain);

}  // namespace pizarra::forms
