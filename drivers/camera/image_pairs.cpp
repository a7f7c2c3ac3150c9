#include "drivers/camera/image_pairs.hpp"

#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

namespace pizarra {
namespace {

constexpr const char* digits = "0123456789";

std::optional<std::uint64_t> number_in(const std::string& file) {
  const std::string name = std::filesystem::path(file).stem().string();
  const std::size_t last = name.find_last_of(digits);
  if (last == std::string::npos) return std::nullopt;
  const std::size_t before = name.find_last_not_of(digits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(name.data() + first, name.data() + last + 1, number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

// Empty where a name has none, or one that another has too.
std::map<std::uint64_t, std::string> by_number(const std::vector<std::string>& files) {
  std::map<std::uint64_t, std::string> out;
  for (const std::string& file : files) {
    const std::optional<std::uint64_t> number = number_in(file);
    if (!number || !out.emplace(*number, file).second) return {};
  }
  return out;
}

// No number in any name, or the same in all, as a camera's own.
bool are_unnumbered(const std::vector<std::string>& files) {
  std::set<std::optional<std::uint64_t>> numbers;
  for (const std::string& file : files) numbers.insert(number_in(file));
  return numbers.size() <= 1;
}

}  // namespace

Result<ImagePairs> pair_files(std::vector<std::string> left, std::vector<std::string> right) {
  const std::map<std::uint64_t, std::string> numbered_left = by_number(left);
  const std::map<std::uint64_t, std::string> numbered_right = by_number(right);
  ImagePairs pairs;
  for (const std::string& file : left) {
    if (numbered_left.empty()) break;
    const auto partner = numbered_right.find(*number_in(file));
    if (partner == numbered_right.end()) continue;
    pairs.sides[0].push_back(file);
    pairs.sides[1].push_back(partner->second);
  }
  const std::size_t count = pairs.sides[0].size();
  if (2 * count > std::min(left.size(), right.size())) {
    pairs.alone = {left.size() - count, right.size() - count};
    return pairs;
  }
  // Numbers of which some are on the other side too contradict any other order.
  const bool counted_apart = count == 0 && !numbered_left.empty() && !numbered_right.empty();
  const bool by_order = counted_apart || (are_unnumbered(left) && are_unnumbered(right));
  if (by_order && left.size() == right.size()) return ImagePairs{{std::move(left), std::move(right)}, {}};
  return fail("unpaired", fmt::format("{} images are of the left camera and {} of the right one, and the numbers in "
                                      "their names do not say which belong together",
                                      left.size(), right.size()));
}

}  // namespace pizarra
