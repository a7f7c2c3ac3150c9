#pragma once

// Pairs the files of two image sequences that belong together, by the first of these rules that fits:
//   - Files of the same name are a pair. The rule fits where most names of the shorter side are on the other side too.
//   - Files with equal numbers in their names are a pair. The rule fits where most numbers of the shorter side are on
//     the other side too. Numbers that never change on a side do not count. Where several change, all must be equal.
//   - Files with numbers equally far apart are a pair. The rule fits where no number is on both sides.
//   - The files are paired in the order of their names. The rule fits where no number tells them apart.
// The last two rules need as many files on one side as on the other. Files without a partner are left out. Pairs come
// in the order of the left side's names.
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
