#include "programs/chaos/reference.hpp"

#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <set>

namespace pizarra::chaos {

namespace {

struct Count {
  const char* name;
  std::uint64_t Reference::*value;
};
constexpr Count counts[] = {{"runs", &Reference::runs},
                            {"first-seed", &Reference::first_seed},
                            {"failed", &Reference::failed},
                            {"unsafe", &Reference::unsafe},
                            {"hung", &Reference::hung}};
// These may only go down.
constexpr Count bounds[] = {{"failed", &Reference::failed}, {"unsafe", &Reference::unsafe}, {"hung", &Reference::hung}};

struct Line {
  std::string name;
  std::uint64_t value = 0;
};

std::optional<Line> line_from(const std::string& text) {
  const std::size_t space = text.rfind(' ');
  if (space == std::string::npos || space == 0) return std::nullopt;
  Line line{text.substr(0, space), 0};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + space + 1, end, line.value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return line;
}

std::string changed(const Count& count, const Reference& before, const Reference& now) {
  return fmt::format("{} {}, and {} in the reference", count.name, now.*count.value, before.*count.value);
}

}  // namespace

Reference reference_of(std::uint64_t first_seed, const Tally& tally) {
  return {.runs = tally.runs,
          .first_seed = first_seed,
          .failed = tally.failed,
          .unsafe = tally.unsafe,
          .hung = tally.hung,
          .coverage = tally.coverage};
}

std::string text_of(const Reference& reference) {
  std::string text;
  for (const Count& count : counts) text += fmt::format("{} {}\n", count.name, reference.*count.value);
  return text + reference.coverage.text();
}

Result<Reference> read_reference(const std::string& file) {
  Reference reference;
  std::set<std::string> missing;
  for (const Count& count : counts) missing.insert(count.name);
  std::ifstream in(file);
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    const std::optional<Line> line = line_from(text);
    if (!line) return fail("bad-reference", fmt::format("{}:{}: not a name and a count", file, ++number));
    ++number;
    bool is_count = false;
    for (const Count& count : counts) {
      if (line->name != count.name) continue;
      reference.*count.value = line->value;
      is_count = true;
    }
    missing.erase(line->name);
    if (!is_count) reference.coverage.hit(line->name, line->value);
  }
  if (missing.empty()) return reference;
  return fail("bad-reference", fmt::format("{}:{}: it has no line \"{} COUNT\"", file, number, *missing.begin()));
}

std::vector<std::string> worse_than(const Reference& reference, const Reference& now) {
  std::vector<std::string> sentences;
  for (const Count& bound : bounds) {
    if (now.*bound.value > reference.*bound.value) sentences.push_back("worse: " + changed(bound, reference, now));
  }
  for (const std::string& point : now.coverage.lost_since(reference.coverage)) sentences.push_back("lost: " + point);
  return sentences;
}

std::vector<std::string> better_than(const Reference& reference, const Reference& now) {
  std::vector<std::string> sentences;
  for (const Count& bound : bounds) {
    if (now.*bound.value < reference.*bound.value) sentences.push_back("better: " + changed(bound, reference, now));
  }
  return sentences;
}

}  // namespace pizarra::chaos
