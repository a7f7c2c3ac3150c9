#include "programs/chaos/shrink.hpp"

#include <numeric>

namespace pizarra::chaos {

std::vector<std::size_t> shrink(const ChaosStory& story, const std::string& plant) {
  std::vector<std::size_t> fewest(story.faults.size());
  std::iota(fewest.begin(), fewest.end(), 0);
  int runs = 0;
  for (std::size_t part = (fewest.size() + 1) / 2; part > 0;) {
    bool smaller = false;
    for (std::size_t from = 0; from < fewest.size() && runs < most_shrinking_runs;) {
      std::vector<std::size_t> without = fewest;
      const std::size_t to = std::min(from + part, without.size());
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(from),
                    without.begin() + static_cast<std::ptrdiff_t>(to));
      ++runs;
      if (play_quietly(story, {.faults = without, .plant = plant}).has_failed()) {
        fewest = without;
        smaller = true;
      } else {
        from += part;
      }
    }
    if (!smaller || part > 1) part = part == 1 ? 0 : (part + 1) / 2;
    if (runs >= most_shrinking_runs) break;
  }
  return fewest;
}

}  // namespace pizarra::chaos
