#include "blackboard/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace pizarra {

namespace {

// Levenshtein's distance, one row at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view wrong, const std::vector<std::string>& names) {
  constexpr std::size_t longest_considered = 64;
  wrong = wrong.substr(0, longest_considered);
  std::string best;
  std::size_t best_distance = wrong.size() / 2 + 1;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(wrong, std::string_view(name).substr(0, longest_considered));
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace pizarra
