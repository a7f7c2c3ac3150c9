#include "blackboard/store/ordered_index.hpp"

#include "blackboard/store/compare_values.hpp"

namespace pizarra::store {

void ValueRange::begin_at(const Datum& value, bool itself) {
  const std::strong_ordering order = from ? compare_values(value, *from) : std::strong_ordering::greater;
  if (order < 0) return;
  from_itself = itself && (order > 0 || from_itself);
  from = value;
}

void ValueRange::end_at(const Datum& value, bool itself) {
  const std::strong_ordering order = to ? compare_values(value, *to) : std::strong_ordering::less;
  if (order > 0) return;
  to_itself = itself && (order < 0 || to_itself);
  to = value;
}

bool ValueRange::is_empty() const {
  if (!from || !to) return false;
  const std::strong_ordering order = compare_values(*from, *to);
  return order > 0 || (order == 0 && !(from_itself && to_itself));
}

bool ValueRange::has(const Datum& value) const {
  const std::strong_ordering after_from = from ? compare_values(value, *from) : std::strong_ordering::greater;
  const std::strong_ordering after_to = to ? compare_values(value, *to) : std::strong_ordering::less;
  return (after_from > 0 || (after_from == 0 && from_itself)) && (after_to < 0 || (after_to == 0 && to_itself));
}

bool ByArgument::operator()(const StandingFact* a, const StandingFact* b) const {
  const std::strong_ordering order = compare_values(value(a), value(b));
  return order != 0 ? order < 0 : a->fact.id < b->fact.id;
}

bool ByArgument::operator()(const StandingFact* a, const Edge& b) const {
  const std::strong_ordering order = compare_values(value(a), b.value);
  return order != 0 ? order < 0 : b.after;
}

bool ByArgument::operator()(const Edge& a, const StandingFact* b) const {
  const std::strong_ordering order = compare_values(a.value, value(b));
  return order != 0 ? order < 0 : !a.after;
}

OrderedFacts facts_within(const OrderedIndex& index, const ValueRange& range) {
  if (range.is_empty()) return {index.end(), index.end()};
  const auto edge = [](const Datum& value, bool after) { return ByArgument::Edge{value, after}; };
  const auto first = range.from ? index.lower_bound(edge(*range.from, !range.from_itself)) : index.begin();
  const auto last = range.to ? index.lower_bound(edge(*range.to, range.to_itself)) : index.end();
  return {first, last};
}

}  // namespace pizarra::store
