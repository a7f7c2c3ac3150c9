#pragma once

// The weight of a datum: how much room its text takes, how many elements it has, how deep its lists nest. A list
// remembers it, so that whoever asks again, of it or of what holds it, need not look at its elements.
//
//   const Weight weight = weigh(read_one("(seen \"circle\" 112)").value());
//   weight.elements;    // 4: the list counts as well
//   weight.depth;       // 1

#include <cstddef>

#include "lisp/datum.hpp"

namespace pizarra {

// Never less than the text takes.
struct Weight {
  std::size_t bytes = 0;
  std::size_t elements = 0;
  std::size_t depth = 0;

  Weight& operator+=(const Weight& other);
  bool operator==(const Weight&) const = default;
};

Weight weigh(const Datum& datum);

}  // namespace pizarra
