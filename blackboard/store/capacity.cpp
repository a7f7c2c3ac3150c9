#include "blackboard/store/capacity.hpp"

namespace pizarra::store {

namespace {

// No less than what its tells may take.
std::size_t most_bytes(const Transaction& transaction, const Weight& weight) {
  Fact any;
  any.teller = std::string(limits::name_bytes, 'x');
  return transaction.steps.size() * footprint(any) + footprint({}, weight);
}

}  // namespace

Weight weigh(const Transaction& transaction) {
  constexpr std::size_t envelope = 64;
  Weight whole;
  const auto add = [&](const Datum& datum, std::size_t ids) {
    whole += weigh(datum);
    whole.bytes += envelope + ids * limits::id_bytes;
    whole.elements += 6 + ids;
  };
  for (const auto& precondition : transaction.preconditions) {
    std::visit([&](const auto& p) { add(p.pattern, 1); }, precondition);
  }
  for (const Transaction::Step& step : transaction.steps) {
    if (const auto* tell = std::get_if<Transaction::Tell>(&step)) add(tell->fact, tell->because.size() + 1);
    if (const auto* retract = std::get_if<Transaction::Retract>(&step)) add(retract->pattern, 0);
    if (std::holds_alternative<Transaction::Settle>(step)) add({}, 1);
  }
  return whole;
}

Result<void> check_room(const Transaction& transaction, const Weight& weight, const std::string& teller,
                        const Tables& tables, const Load& taken) {
  const bool few = taken.facts + transaction.steps.size() <= limits::facts;
  if (few && taken.bytes + most_bytes(transaction, weight) <= limits::board_bytes) return {};
  Load added;
  for (const Transaction::Step& step : transaction.steps) {
    const auto* tell = std::get_if<Transaction::Tell>(&step);
    if (tell == nullptr) continue;
    const StandingFact* former = tables.find(tell->fact.head())->second.find_key_of(tell->fact);
    const std::size_t before = former == nullptr ? 0 : footprint(former->fact);
    const std::size_t after = footprint({.datum = tell->fact, .teller = teller, .because = tell->because});
    if (former == nullptr) ++added.facts;
    if (after > before) added.bytes += after - before;
  }
  if (added.facts > 0 && taken.facts + added.facts > limits::facts) {
    return fail("too-large", "the board is full: it has " + std::to_string(limits::facts) + " facts");
  }
  if (added.bytes > 0 && taken.bytes + added.bytes > limits::board_bytes) {
    return fail("too-large", "the board is full: its facts take " + std::to_string(limits::board_bytes) + " bytes");
  }
  return {};
}

}  // namespace pizarra::store
