#include "drivers/camera/image_pairs.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

#include "lisp/plain_text.hpp"

namespace pizarra::camera {
namespace {

constexpr const char* digits = "0123456789";
constexpr std::string_view advice = "give what belongs together the same number, or take out the numbers";

// Without the zeros before them, so that 02 is 2.
using Numbers = std::vector<std::string>;

std::string name_of(const std::string& file) { return std::filesystem::path(file).filename().string(); }

Numbers numbers_in(const std::string& file) {
  const std::string name = std::filesystem::path(file).stem().string();
  Numbers out;
  std::size_t first = name.find_first_of(digits);
  while (first != std::string::npos) {
    const std::size_t end = std::min(name.find_first_not_of(digits, first), name.size());
    const std::size_t sense = std::min(name.find_first_not_of('0', first), end - 1);
    out.push_back(name.substr(sense, end - sense));
    first = name.find_first_of(digits, end);
  }
  return out;
}

// One side's, file by file.
Result<std::vector<Numbers>> numbers_of(const std::vector<std::string>& files) {
  std::vector<Numbers> out;
  for (const std::string& file : files) {
    out.push_back(numbers_in(file));
    if (out.back().size() == out.front().size()) continue;
    return fail("unpaired", fmt::format("{} has {} numbers in its name and {} has {}: {}", name_of(files.front()),
                                        out.front().size(), name_of(file), out.back().size(), advice));
  }
  return out;
}

// Which of the numbers in its names tell one side's images apart.
std::set<std::size_t> varying(const std::vector<Numbers>& names) {
  std::set<std::size_t> out;
  for (const Numbers& name : names) {
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (name[i] != names.front()[i]) out.insert(i);
    }
  }
  return out;
}

using ByNumbers = std::map<Numbers, std::string>;

Result<ByNumbers> by_numbers(const std::vector<std::string>& files, const std::vector<Numbers>& numbers) {
  ByNumbers out;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto [there, added] = out.emplace(numbers[i], files[i]);
    if (added) continue;
    return fail("unpaired",
                fmt::format("{} and {} have the same number: {}", name_of(there->second), name_of(files[i]), advice));
  }
  return out;
}

std::optional<std::int64_t> as_integer(const Numbers& numbers) {
  if (numbers.size() != 1) return std::nullopt;
  const std::string& text = numbers.front();
  constexpr std::size_t most_digits = 18;  // sums of two are within 64 bits
  return text.size() > most_digits ? std::nullopt : number_from<std::int64_t>(text);
}

// Of the images of one side, in the order of their names.
struct SideFiles {
  std::vector<std::string> files;
  std::vector<Numbers> numbers;  // of those that tell images apart
};

// Whether more than half of the shorter side's have partners.
bool are_most(const ImagePairs& pairs, std::size_t left, std::size_t right) {
  return 2 * pairs.sides[0].size() > std::min(left, right);
}

// Pairs the images whose numbers are equal.
ImagePairs matched(const SideFiles& left, const ByNumbers& right) {
  ImagePairs out;
  for (std::size_t i = 0; i < left.files.size(); ++i) {
    const auto partner = right.find(left.numbers[i]);
    if (partner == right.end()) continue;
    out.sides[0].push_back(left.files[i]);
    out.sides[1].push_back(partner->second);
  }
  const std::size_t count = out.sides[0].size();
  out.alone = {left.files.size() - count, right.size() - count};
  return out;
}

// Counted alike on both sides, but from another number on.
std::optional<ImagePairs> counted_apart(const SideFiles& left, const SideFiles& right) {
  const auto integers_of = [](const SideFiles& side) -> std::optional<std::map<std::int64_t, std::string>> {
    std::map<std::int64_t, std::string> out;
    for (std::size_t i = 0; i < side.files.size(); ++i) {
      const std::optional<std::int64_t> number = as_integer(side.numbers[i]);
      if (!number) return std::nullopt;
      out.emplace(*number, side.files[i]);
    }
    return out;
  };
  const auto lefts = integers_of(left);
  const auto rights = integers_of(right);
  if (!lefts || !rights || lefts->size() != rights->size()) return std::nullopt;
  const std::int64_t apart = rights->begin()->first - lefts->begin()->first;
  ImagePairs out;
  for (std::size_t i = 0; i < left.files.size(); ++i) {
    const auto partner = rights->find(*as_integer(left.numbers[i]) + apart);
    if (partner == rights->end()) return std::nullopt;
    out.sides[0].push_back(left.files[i]);
    out.sides[1].push_back(partner->second);
  }
  return out;
}

// Names without their extension stand for numbers here.
std::vector<Numbers> stems_of(const std::vector<std::string>& files) {
  std::vector<Numbers> out;
  for (const std::string& file : files) out.push_back({std::filesystem::path(file).stem().string()});
  return out;
}

Failure unpaired(const SideFiles& left, const ByNumbers& right) {
  std::string example;
  for (std::size_t i = left.files.size(); i-- > 0;) {
    if (!right.contains(left.numbers[i])) example = name_of(left.files[i]);
  }
  return {"unpaired",
          fmt::format("{} images are of the left camera and {} of the right one, and the numbers in their names do not "
                      "say which belong together, as of {}: {}",
                      left.files.size(), right.size(), example, advice),
          {},
          {}};
}

std::vector<Numbers> at_places(const std::vector<Numbers>& names, const std::set<std::size_t>& places) {
  std::vector<Numbers> out;
  for (const Numbers& name : names) {
    Numbers& numbers = out.emplace_back();
    for (const std::size_t place : places) numbers.push_back(name[place]);
  }
  return out;
}

Result<ImagePairs> in_order(std::vector<std::string> left, std::vector<std::string> right) {
  if (left.size() == right.size()) return ImagePairs{{std::move(left), std::move(right)}, {}};
  return fail("unpaired", fmt::format("{} images are of the left camera and {} of the right one, and no numbers in "
                                      "their names say which belong together: give what belongs together the same "
                                      "number",
                                      left.size(), right.size()));
}

}  // namespace

Result<ImagePairs> pair_files(std::vector<std::string> left, std::vector<std::string> right) {
  const Result<ByNumbers> right_stems = by_numbers(right, stems_of(right));
  if (right_stems) {
    ImagePairs same = matched({left, stems_of(left)}, *right_stems);
    if (are_most(same, left.size(), right.size())) return same;
  }
  const Result<std::vector<Numbers>> left_names = numbers_of(left);
  const Result<std::vector<Numbers>> right_names = numbers_of(right);
  if (!left_names) return fail(left_names);
  if (!right_names) return fail(right_names);
  std::set<std::size_t> left_places = varying(*left_names);
  std::set<std::size_t> right_places = varying(*right_names);
  const bool none_vary = left_places.empty() && right_places.empty();
  if (none_vary || left.empty() || right.empty()) return in_order(std::move(left), std::move(right));
  // Of names that are built alike: what is the same all over one side may yet say which one of the other's it is.
  if (left_names->front().size() == right_names->front().size()) {
    left_places.insert(right_places.begin(), right_places.end());
    right_places = left_places;
  }
  const SideFiles left_side{std::move(left), at_places(*left_names, left_places)};
  const SideFiles right_side{std::move(right), at_places(*right_names, right_places)};
  const Result<ByNumbers> numbered_left = by_numbers(left_side.files, left_side.numbers);
  const Result<ByNumbers> numbered_right = by_numbers(right_side.files, right_side.numbers);
  if (!numbered_left) return fail(numbered_left);
  if (!numbered_right) return fail(numbered_right);
  ImagePairs pairs = matched(left_side, *numbered_right);
  if (are_most(pairs, left_side.files.size(), right_side.files.size())) return pairs;
  // Numbers of which some are on the other side too contradict any other order.
  std::optional<ImagePairs> apart = pairs.sides[0].empty() ? counted_apart(left_side, right_side) : std::nullopt;
  if (apart) return std::move(*apart);
  return std::unexpected(unpaired(left_side, *numbered_right));
}

}  // namespace pizarra::camera
