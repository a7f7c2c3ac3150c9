#pragma once

// The known name a mistyped one was probably meant to be, for error sentences.
//
//   nearest_name("cirle", {"circle", "square"})   // "circle"
//   nearest_name("circ", {"circle", "square"})    // "circle": its beginning
//   nearest_name("x", {"circle"})                 // "": nothing is near enough to be a help

#include <algorithm>
#include <array>
#include <cstdlib>
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

// No fewer edits lead from one to the other: as many letters as one has and the other has not.
inline std::size_t least_edits(std::string_view a, std::string_view b) {
  std::array<int, 256> more{};
  for (const char letter : a) ++more[static_cast<unsigned char>(letter)];
  for (const char letter : b) --more[static_cast<unsigned char>(letter)];
  std::size_t apart = 0;
  for (const int letters : more) apart += static_cast<std::size_t>(std::abs(letters));
  const std::size_t longer = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  return (apart + longer) / 2;
}

// The first of the nearest, if it is within a third of the name's length; else the shortest that begins with the name,
// which has two letters at least. Never more than 64 letters are compared,
// and no more than 64 names that have much the same letters: it takes no longer than to go through the names.
template <std::ranges::range Names>
std::string nearest_name(std::string_view name, const Names& known) {
  const std::string_view wanted = name.substr(0, 64);
  std::size_t best = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  std::string nearest;
  std::size_t left_to_compare = 64;
  for (const auto& candidate : known) {
    const std::string_view name_known = std::string_view(candidate).substr(0, 64);
    if (least_edits(wanted, name_known) >= best) continue;
    if (left_to_compare-- == 0) break;
    const std::size_t distance = edit_distance(wanted, name_known);
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
