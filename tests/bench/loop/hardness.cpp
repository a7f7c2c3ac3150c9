#include "tests/bench/loop/hardness.hpp"

#include <cmath>

namespace pizarra::bench {

const char* hardness(double ours_percent, double published_percent) {
  constexpr double equal_points = 10;
  const double points = ours_percent - published_percent;
  if (std::abs(points) <= equal_points) return "equal";
  return points > 0 ? "easier" : "harder";
}

}  // namespace pizarra::bench
