#pragma once

// Finds facts of a table by the values of some of their arguments, or in the order of one.
//
//   FactIndex index(FactIndex::by_order(argument), facts);
//   while (!index.is_made()) index.make_some(facts, looking);      // others may be served between the parts
//   index.enter(standing);                                         // as facts come and go, from the beginning on
//   index.leave(standing);
//   while (!index.take_apart(some)) ...                            // before it is destroyed, where that may take long
//
// It is made from the facts that stood when it was begun, by ascending id: it knows which of them it has.

#include <compare>
#include <map>
#include <unordered_map>

#include "blackboard/store/fact_list.hpp"
#include "blackboard/store/ordered_index.hpp"

namespace pizarra::store {

class Looking;

class FactIndex {
 public:
  // A set of arguments, by their positions.
  using Mask = std::uint32_t;
  using Bucket = std::map<FactId, const StandingFact*>;
  struct Kind {
    enum class By : std::uint8_t { values, order };
    By by;
    std::uint32_t which;  // the arguments' mask, or the one argument
    auto operator<=>(const Kind&) const = default;
  };
  static Kind by_values(Mask arguments) { return {Kind::By::values, arguments}; }
  static Kind by_order(std::size_t argument) { return {Kind::By::order, static_cast<std::uint32_t>(argument)}; }

  FactIndex(const Kind& kind, const FactList& facts);
  FactIndex(const FactIndex&) = delete;
  FactIndex& operator=(const FactIndex&) = delete;

  const Kind& kind() const { return kind_; }
  bool is_made() const { return up_to_ >= until_; }
  // Goes on as far as is allowed to look.
  void make_some(const FactList& facts, Looking& looking);
  void enter(const StandingFact& standing);
  void leave(const StandingFact& standing);
  // So many of its facts; answers whether none is left.
  bool take_apart(std::size_t facts);

  // By values: of the facts like this one.
  const Bucket& bucket_of(const Datum& datum) const;
  // By order.
  const OrderedIndex& in_order() const { return in_order_; }

 private:
  // The values of these arguments.
  static Datum arguments_in(Mask mask, const Datum& datum);
  bool has(FactId id) const { return id <= up_to_ || id > until_; }
  void put(const StandingFact& standing);

  const Kind kind_;
  FactId up_to_ = 0;
  const FactId until_;
  std::unordered_map<Datum, Bucket> by_values_;
  OrderedIndex in_order_;
};

}  // namespace pizarra::store
