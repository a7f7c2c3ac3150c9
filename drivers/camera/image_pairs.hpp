#pragma once

// Pairs the files of two image sequences that belong together: those of the same name, where most of the shorter side's
// are on the other too. Else it is by those numbers in their names that are not the same all over a side, so that a
// camera's own says nothing. Where most of the shorter side's are on the other too, equal numbers do (all of them,
// where several change, as dates and times), in the order of the left side's names; what has no partner is left out.
// Where none is on both sides, as many are on either, and each right number is as far from the left one, these do.
// Where no number tells images apart, they belong together in the order of their names, as many on either side. Else
// nobody knows.
//
//   Result<ImagePairs> pairs = pair_files({"l/1-a.png", "l/2-a.png"}, {"r/2-b.png"});   // the two 2s, 1 is alone

#include <array>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::camera {

struct ImagePairs {
  std::array<std::vector<std::string>, 2> sides;  // as many on either
  std::array<std::size_t, 2> alone = {};          // how many of each were left out
};

// Failure: unpaired.
Result<ImagePairs> pair_files(std::vector<std::string> left, std::vector<std::string> right);

}  // namespace pizarra::camera
