#pragma once

// Which files of two image sequences belong together. Where all names on either side carry a number (the last one in
// each, once), and most of those of the shorter side are on the other too, equal numbers do, in the order of the left
// side's names; what has no partner is left out. Where no name has a number, all have the same, or no number is on both
// sides, they belong together in the order of their names, as many on either side. Else nobody knows.
//
//   Result<ImagePairs> pairs = pair_files({"l/a1.png", "l/a2.png"}, {"r/b2.png"});   // a2 with b2, a1 is alone

#include <array>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra {

struct ImagePairs {
  std::array<std::vector<std::string>, 2> sides;  // as many on either
  std::array<std::size_t, 2> alone = {};          // how many of each were left out
};

// Failure: unpaired.
Result<ImagePairs> pair_files(std::vector<std::string> left, std::vector<std::string> right);

}  // namespace pizarra
