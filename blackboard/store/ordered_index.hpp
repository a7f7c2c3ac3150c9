#pragma once

// The facts of a relation by the value of one argument, then by id: finds those in a range of values without looking at
// others.
//
//   OrderedIndex index(ByArgument{0});
//   index.insert(&standing);
//   for (const StandingFact* standing : facts_within(index, {.argument = 0, .from = low, .to = high})) ...

#include <optional>
#include <ranges>
#include <set>

#include "blackboard/store/fact_list.hpp"

namespace pizarra::store {

// The range of an argument; without an end, anything on that side.
struct ValueRange {
  std::size_t argument = 0;
  std::optional<Datum> from = {};
  std::optional<Datum> to = {};
  // Whether the ends belong to it.
  bool from_itself = true;
  bool to_itself = true;

  void begin_at(const Datum& value, bool itself);
  void end_at(const Datum& value, bool itself);
  bool is_empty() const;
  bool has(const Datum& value) const;
};

struct ByArgument {
  using is_transparent = void;
  // Before or after all that have the value.
  struct Edge {
    const Datum& value;
    bool after;
  };
  std::size_t argument;

  const Datum& value(const StandingFact* standing) const { return standing->fact.datum[argument + 1]; }
  bool operator()(const StandingFact* a, const StandingFact* b) const;
  bool operator()(const StandingFact* a, const Edge& b) const;
  bool operator()(const Edge& a, const StandingFact* b) const;
};

using OrderedIndex = std::set<const StandingFact*, ByArgument>;
using OrderedFacts = std::ranges::subrange<OrderedIndex::const_iterator>;

OrderedFacts facts_within(const OrderedIndex& index, const ValueRange& range);

}  // namespace pizarra::store
