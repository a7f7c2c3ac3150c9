#include "blackboard/server/durable_requests.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

namespace {

bool is_durable(const store::Store& store, const Datum& pattern) {
  const auto table = store.tables().find(pattern.head());
  return table != store.tables().end() && table->second.relation().durable;
}

bool step_is_durable(const store::Store& store, const Datum& step) {
  if (step.size() < 2) return false;
  if (!step.is_form("settle")) return is_durable(store, step[1]);
  const Fact* held = store.held(wire::count_from(step[1]).value_or(0));
  return held != nullptr && is_durable(store, held->datum);
}

bool declares_durable(const Datum& relation) {
  return std::ranges::any_of(relation.items(), [](const Datum& part) { return part.is_form("durable"); });
}

}  // namespace

bool concerns_durable(const store::Store& store, const Datum& body) {
  if (body.size() < 2) return false;
  if (body.is_form("take")) return is_durable(store, body[1]);
  if (body.is_form("declare")) return std::ranges::any_of(body.items(), declares_durable);
  if (!body.is_form("transact") || body.size() < 3) return false;
  return std::ranges::any_of(body[2].items(), [&](const Datum& step) { return step_is_durable(store, step); });
}

bool asks_durable(const store::Store& store, const Datum& query) {
  const bool is_made_of_others = query.is_form("and") || query.is_form("not") || query.is_form("query");
  if (!is_made_of_others) return is_durable(store, query);
  return std::ranges::any_of(query.items(), [&](const Datum& part) { return asks_durable(store, part); });
}

bool only_removes(const Datum& body) {
  const auto removes = [](const Datum& step) { return step.is_form("retract") || step.is_form("settle"); };
  return body.is_form("transact") && body.size() > 2 && std::ranges::all_of(body[2].items(), removes);
}

std::size_t bytes_at_most(const Datum& body) {
  if (body.is_form("take")) return limits::frame_bytes + said_beside;
  // Of each fact that is told its id, and the one that it replaces.
  constexpr std::size_t bytes_of_a_step = 3 * bytes_of_a_removal;
  const std::size_t steps = body.is_form("transact") && body.size() > 2 ? body[2].size() : 0;
  return weigh(body).bytes + steps * bytes_of_a_step + said_beside;
}

std::size_t removed_at_most(const store::Store& store, const Transaction& transaction) {
  std::size_t removed = 0;
  for (const Transaction::Step& step : transaction.steps) {
    const auto* retract = std::get_if<Transaction::Retract>(&step);
    if (retract == nullptr) continue;
    const auto table = store.tables().find(retract->pattern.head());
    const bool known = table != store.tables().end() && check_pattern_shape(table->second.relation(), retract->pattern);
    if (known) removed += std::min(table->second.candidates(retract->pattern), table->second.size());
  }
  return removed;
}

}  // namespace pizarra::server
