#include "blackboard/store/fact_index.hpp"

#include <bit>

#include "blackboard/store/looking.hpp"

namespace pizarra::store {

// Growing on the way, it would stand still for as long as a part takes several times over.
FactIndex::FactIndex(const Kind& kind, const FactList& facts)
    : kind_(kind), until_(facts.newest()), in_order_(ByArgument{kind.which}) {
  if (kind_.by == Kind::By::values) by_values_.reserve(facts.size());
}

void FactIndex::make_some(const FactList& facts, Looking& looking) {
  for (const StandingFact& standing : facts.from(up_to_ + 1)) {
    if (standing.fact.id > until_) break;
    if (!looking.at_one_more()) return;
    put(standing);
    up_to_ = standing.fact.id;
  }
  up_to_ = until_;
}

void FactIndex::enter(const StandingFact& standing) {
  if (has(standing.fact.id)) put(standing);
}

void FactIndex::leave(const StandingFact& standing) {
  if (!has(standing.fact.id)) return;
  if (kind_.by == Kind::By::order) {
    in_order_.erase(&standing);
    return;
  }
  const auto place = by_values_.find(arguments_in(kind_.which, standing.fact.datum));
  place->second.erase(standing.fact.id);
  if (place->second.empty()) by_values_.erase(place);
}

void FactIndex::put(const StandingFact& standing) {
  if (kind_.by == Kind::By::order) {
    in_order_.insert(&standing);
    return;
  }
  Bucket& bucket = by_values_[arguments_in(kind_.which, standing.fact.datum)];
  bucket.emplace_hint(bucket.end(), standing.fact.id, &standing);
}

bool FactIndex::take_apart(std::size_t facts) {
  for (; facts > 0 && !in_order_.empty(); --facts) in_order_.erase(in_order_.begin());
  for (; facts > 0 && !by_values_.empty(); --facts) {
    Bucket& bucket = by_values_.begin()->second;
    bucket.erase(bucket.begin());
    if (bucket.empty()) by_values_.erase(by_values_.begin());
  }
  return in_order_.empty() && by_values_.empty();
}

const FactIndex::Bucket& FactIndex::bucket_of(const Datum& datum) const {
  static const Bucket none;
  const auto found = by_values_.find(arguments_in(kind_.which, datum));
  return found == by_values_.end() ? none : found->second;
}

Datum FactIndex::arguments_in(Mask mask, const Datum& datum) {
  std::vector<Datum> arguments;
  arguments.reserve(static_cast<std::size_t>(std::popcount(mask)));
  for (std::size_t i = 0; i + 1 < datum.size(); ++i) {
    if ((mask >> i & 1U) != 0) arguments.push_back(datum[i + 1]);
  }
  return Datum::list(std::move(arguments));
}

}  // namespace pizarra::store
