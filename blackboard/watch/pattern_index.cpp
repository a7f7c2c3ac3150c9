#include "blackboard/watch/pattern_index.hpp"

#include <algorithm>
#include <cmath>

#include "blackboard/store/narrowing.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::watch {

namespace {

using Kind = Query::Clause::Kind;

bool has_one_value(const store::ValueRange& range) {
  return range.from && range.to && !range.is_empty() && store::compare_values(*range.from, *range.to) == 0;
}

// The range that orders what is filed together, if any.
const store::ValueRange* ordering(const WatchedPattern& pattern) {
  const auto found = std::ranges::find_if(
      pattern.ranges, [&](const store::ValueRange& range) { return range.argument + 1 != pattern.place; });
  return found == pattern.ranges.end() ? nullptr : &*found;
}

}  // namespace

bool WatchedPattern::may_fit(const Datum& fact) const {
  return resembles(pattern, fact) && std::ranges::all_of(ranges, [&](const store::ValueRange& range) {
           return range.has(fact[range.argument + 1]);
         });
}

// A variable under `not` may be another than the one that is compared.
std::vector<WatchedPattern> patterns_of(const Query& query, WatchQueue* watch) {
  std::vector<WatchedPattern> patterns;
  for (const auto& [kind, form] : query.clauses) {
    if (kind == Kind::compare) continue;
    std::vector<store::ValueRange> ranges;
    for (const Query::Clause& other : query.clauses) {
      if (kind == Kind::fact && other.kind == Kind::compare) store::narrow(ranges, form, other.form);
    }
    patterns.push_back({watch, form, std::move(ranges)});
  }
  return patterns;
}

Datum PatternIndex::by_value(const Datum& value) {
  const double number = value.number();
  const bool is_whole = value.is_real() && number == std::floor(number);
  if (!is_whole || number >= store::beyond_integers || number < -store::beyond_integers) return value;
  return Datum::integer(static_cast<std::int64_t>(number));
}

std::optional<Datum> PatternIndex::value_at(std::size_t place, const WatchedPattern& pattern) {
  if (is_ground(pattern.pattern[place])) return by_value(pattern.pattern[place]);
  const auto range = std::ranges::find(pattern.ranges, place - 1, &store::ValueRange::argument);
  if (range == pattern.ranges.end() || !has_one_value(*range)) return std::nullopt;
  return by_value(*range->from);
}

void PatternIndex::add(WatchedPattern& pattern) {
  pattern.place = 0;
  std::size_t fewest = 0;
  Datum best;
  for (std::size_t place = 1; place < pattern.pattern.size(); ++place) {
    std::optional<Datum> value = value_at(place, pattern);
    if (!value) continue;
    const std::size_t others = size_of_file(place, *value);
    if (pattern.place != 0 && others >= fewest) continue;
    pattern.place = place;
    fewest = others;
    best = std::move(*value);
  }
  File& chosen = pattern.place == 0 ? together_ : by_argument_[pattern.place][best];
  chosen.add(pattern);
}

std::size_t PatternIndex::size_of_file(std::size_t place, const Datum& value) const {
  const auto files = by_argument_.find(place);
  if (files == by_argument_.end()) return 0;
  const auto file = files->second.find(value);
  return file == files->second.end() ? 0 : file->second.size();
}

void PatternIndex::remove(const WatchedPattern& pattern) {
  if (pattern.place == 0) return together_.remove(pattern);
  const auto files = by_argument_.find(pattern.place);
  const auto found = files->second.find(*value_at(pattern.place, pattern));
  found->second.remove(pattern);
  if (found->second.size() == 0) files->second.erase(found);
  if (files->second.empty()) by_argument_.erase(files);
}

void PatternIndex::File::add(const WatchedPattern& pattern) {
  ++size_;
  const store::ValueRange* range = ordering(pattern);
  if (range == nullptr) return unordered_.push_back(&pattern);
  Ends& ends = by_range_[range->argument];
  Patterns& patterns = range->from ? ends.from[*range->from] : ends.to[*range->to];
  patterns.push_back(&pattern);
}

void PatternIndex::File::remove(const WatchedPattern& pattern) {
  --size_;
  const store::ValueRange* range = ordering(pattern);
  if (range == nullptr) {
    std::erase(unordered_, &pattern);
    return;
  }
  const auto ends = by_range_.find(range->argument);
  ByEnd& by_end = range->from ? ends->second.from : ends->second.to;
  const auto patterns = by_end.find(range->from ? *range->from : *range->to);
  std::erase(patterns->second, &pattern);
  if (patterns->second.empty()) by_end.erase(patterns);
  if (ends->second.from.empty() && ends->second.to.empty()) by_range_.erase(ends);
}

}  // namespace pizarra::watch
