#pragma once

// The known name a mistyped one was probably meant to be, for error sentences.
//
//   nearest_name("cirle", {"circle", "square"})   // "circle"
//   nearest_name("circ", {"circle", "square"})    // "circle": its beginning
//   nearest_name("x", {"circle"})                 // "": nothing is near enough to be a help

#include <algorithm>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace pizarra {

// Edit distance in which swapping two neighbours is one edit (optimal string alignment).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

// The first of the nearest, if it is within a third of the name's length; else the shortest that begins with the name,
// which has two letters at least. Never more than 64 letters are compared.
template <std::ranges::range Names>
std::string nearest_name(std::string_view name, const Names& known) {
  const std::string_view wanted = name.substr(0, 64);
  std::size_t best = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  std::string nearest;
  for (const auto& candidate : known) {
    const std::size_t distance = edit_distance(wanted, std::string_view(candidate).substr(0, 64));
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  if (!nearest.empty() || wanted.size() < 2) return nearest;
  for (const auto& candidate : known) {
    const std::string_view whole = candidate;
    if (whole.starts_with(name) && (nearest.empty() || whole.size() < nearest.size())) nearest = whole;
  }
  return nearest;
}

}  // namespace pizarra
