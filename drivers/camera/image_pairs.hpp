#pragma once

// Pairs the files of two image sequences that belong together, by the first of these rules that fits:
//   - the same name, where most names of the shorter side are on the other side too
//   - equal numbers in the names, where most numbers of the shorter side are on the other side too. Numbers that are
//   the
//     same all over a side do not count; where several change, as dates and times, all of them must be equal.
//   - numbers equally far apart, where none is on both sides and both have as many files
//   - the order of the names, where no number tells them apart and both have as many files
// Files without a partner are left out. Pairs come in the order of the left side's names.
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
