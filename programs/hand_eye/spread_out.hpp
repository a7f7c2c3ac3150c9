#pragma once

// A few of many things, far apart from one another: each the farthest from those chosen before it.
//
//   const std::vector<CarriedPose> few = spread_out(poses, 28, apart);     // apart(one, other), any measure

#include <algorithm>
#include <limits>
#include <vector>

namespace pizarra::hand_eye {

template <class Thing, class Apart>
std::vector<Thing> spread_out(const std::vector<Thing>& things, std::size_t wanted, const Apart& apart) {
  std::vector<Thing> chosen;
  std::vector<double> nearest(things.size(), std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  while (chosen.size() < std::min(wanted, things.size())) {
    chosen.push_back(things[next]);
    for (std::size_t i = 0; i < things.size(); ++i) nearest[i] = std::min(nearest[i], apart(things[i], things[next]));
    next = static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin());
  }
  return chosen;
}

}  // namespace pizarra::hand_eye
