#include "tests/bench/loop/share.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::bench {

Share share_of(int successes, int runs) {
  constexpr double z = 1.959964;  // 95 % of a normal distribution lie within
  if (runs == 0) return {0, 0, 100};
  const double n = runs;
  const double share = successes / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n)) / (1 + z * z / n);
  return {100 * share, 100 * std::max(0.0, middle - half), 100 * std::min(1.0, middle + half)};
}

}  // namespace pizarra::bench
