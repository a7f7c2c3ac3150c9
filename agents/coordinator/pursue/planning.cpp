#include "agents/coordinator/pursue/planning.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration reply_timeout = 15s;
constexpr Duration planning_timeout = 60s;

Datum form(const Datum& head, std::vector<Datum> items) {
  items.insert(items.begin(), head);
  return Datum::list(std::move(items));
}

}  // namespace

Task<Result<Datum>> Planning::ask(Datum operation) {
  const Time deadline = context_.executor.now() + options_.absence_patience;
  const Duration patience = operation.is_form("get-plan") ? planning_timeout : reply_timeout;
  const bool here = co_await presence_.wait_for(options_.planner, deadline);
  if (!here) {
    co_return fail("absent", "the planner agent stays away", Datum::symbol(options_.planner));
  }
  const Result<Datum> reply = co_await caller_.call(options_.planner, operation, patience);
  co_return reply;
}

Datum Planning::operators() const {
  std::vector<Datum> forms;
  for (const forms::Operator& known : domain_.domain().operators) forms.push_back(forms::operator_form(known));
  return list("get-operations"_sym, Datum::list(std::move(forms)));
}

Datum Planning::task(const std::vector<Datum>& goal) const {
  std::vector<Datum> types;
  for (const auto& [name, sighting] : surroundings_.scene().sightings().all()) {
    const bool here = surroundings_.scene().sightings().recent(name, static_cast<std::uint64_t>(options_.grace_looks));
    if (!here || name == options_.gripper.mark) continue;
    types.push_back(list(Datum::symbol(name), Datum::symbol(domain_.perception().sees())));
  }
  for (const forms::TypedName& object : domain_.domain().objects) {
    types.push_back(list(Datum::symbol(object.name), Datum::symbol(object.type)));
  }
  Facts initials = surroundings_.beliefs();
  initials.insert(domain_.domain().facts.begin(), domain_.domain().facts.end());
  return list("get-facts"_sym, form("types"_sym, std::move(types)),
              form("initials"_sym, {initials.begin(), initials.end()}), form("goals"_sym, goal));
}

Task<Result<std::vector<GroundOperation>>> Planning::plan(std::vector<Datum> goal) {
  const Datum questions[] = {operators(), task(goal), list("get-plan"_sym)};
  Result<Datum> reply = Datum();
  for (const Datum& question : questions) {
    reply = co_await ask(question);
    if (!reply) co_return fail(reply);
  }
  std::vector<GroundOperation> plan;
  const std::size_t steps = reply->size() == 0 ? 0 : (*reply)[0].size();
  for (std::size_t i = 0; i < steps; ++i) {
    for (const Datum& operation : (*reply)[0][i].items()) {
      Result<GroundOperation> ground = domain_.ground(operation);
      if (!ground) co_return fail(ground);
      plan.push_back(std::move(*ground));
    }
  }
  co_return plan;
}

Task<std::optional<Datum>> Planning::operation(std::size_t index) {
  if (!presence_.has(options_.planner)) co_return std::nullopt;
  const Datum question = index == 0 ? list("start-plan"_sym) : list("next-operation"_sym, index);
  const Result<Datum> reply = co_await caller_.call(options_.planner, question, reply_timeout);
  if (!reply || reply->size() == 0) co_return std::nullopt;
  co_return (*reply)[0];
}

}  // namespace pizarra::coordinator
