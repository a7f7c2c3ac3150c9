#include "agents/coordinator/pursue/planning.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

constexpr Duration answer_timeout = 15s;
constexpr Duration planning_timeout = 60s;

Facts facts_of(const Datum& facts) { return {facts.items().begin(), facts.items().end()}; }

}  // namespace

// A planner that died meanwhile leaves the request to its successor, or, where another stands in, to that.
Task<Result<Datum>> Planning::ask(Datum operation, Duration patience) {
  const Time deadline = context_.executor.now() + options_.absence_patience;
  Result<Datum> reply = fail("replaced", "no planner could be asked");
  while (true) {
    const bool here = co_await roles_.wait_for("planner", deadline);
    const Datum planner = Datum::symbol(roles_.holder("planner").server);
    if (!here) co_return fail("absent", "the planner agent stays away", planner);
    reply = co_await caller_.call(roles_.player("planner"), operation, patience);
    const bool silent = !reply && reply.error().symbol == "timeout";
    if (silent) co_return fail("absent", "the planner agent does not answer", planner);
    const bool replaced = !reply && reply.error().symbol == "replaced";
    if (!replaced || context_.executor.now() > deadline) co_return reply;
  }
}

Datum Planning::operators() const {
  std::vector<Datum> forms;
  for (const forms::Operator& known : domain_.domain().operators) forms.push_back(forms::operator_form(known));
  return Datum::list(std::move(forms));
}

forms::TypedObjects Planning::objects() const {
  forms::TypedObjects objects;
  const Sightings& sightings = surroundings_.scene().sightings();
  for (const auto& [name, sighting] : sightings.all()) {
    const bool here = sightings.remembered(name, options_.grace_looks);
    if (here && name != options_.gripper.mark) objects.emplace_back(name, domain_.perception().sees());
  }
  for (const forms::TypedName& object : domain_.domain().objects) objects.emplace_back(object.name, object.type);
  return objects;
}

Datum Planning::types() const {
  std::vector<Datum> types{"types"_sym};
  for (const auto& [name, type] : objects()) types.push_back(list(Datum::symbol(name), Datum::symbol(type)));
  return Datum::list(std::move(types));
}

// These facts and those that always hold by the domain, as a list with this head.
Datum Planning::holding(std::string_view head, const Facts& from) const {
  Facts facts = from;
  facts.insert(domain_.domain().facts.begin(), domain_.domain().facts.end());
  std::vector<Datum> items(facts.begin(), facts.end());
  if (!head.empty()) items.insert(items.begin(), Datum::symbol(head));
  return Datum::list(std::move(items));
}

// (HEAD ... (OPERATOR ...) (types ...) (initials ...) (goals ...)).
Datum Planning::question(std::vector<Datum> head, std::vector<Datum> goal, const Facts& from) const {
  goal.insert(goal.begin(), "goals"_sym);
  head.insert(head.end(), {operators(), types(), holding("initials", from), Datum::list(std::move(goal))});
  return Datum::list(std::move(head));
}

Task<Result<std::vector<Datum>>> Planning::plan_of(Datum question) {
  const Result<Datum> reply = co_await ask(question, planning_timeout);
  if (!reply) co_return fail(reply);
  std::vector<Datum> operations;
  if (reply->size() != 1) co_return fail("bad-reply", "the planner answered without a plan", *reply);
  for (const Datum& step : (*reply)[0].items()) {
    operations.insert(operations.end(), step.items().begin(), step.items().end());
  }
  co_return operations;
}

Task<Result<std::vector<Datum>>> Planning::make_plan(std::int64_t goal, std::vector<Datum> facts) {
  return plan_of(question({"make-plan"_sym, to_datum(goal)}, std::move(facts), surroundings_.beliefs()));
}

Task<Result<std::vector<Datum>>> Planning::try_plan(std::vector<Datum> facts, Facts from) {
  return plan_of(question({"try-plan"_sym}, std::move(facts), from));
}

Task<Result<NextOperation>> Planning::next(std::int64_t goal) {
  const Datum question = list("next-operation"_sym, goal, holding({}, surroundings_.beliefs()));
  const Result<Datum> reply = co_await ask(question, answer_timeout);
  if (!reply) co_return fail(reply);
  co_return read(*reply);
}

Result<NextOperation> Planning::read(const Datum& reply) const {
  if (reply.size() != 4) return fail("bad-reply", "the planner handed out no operation", reply);
  NextOperation next{static_cast<std::size_t>(reply[0].integer()), {}, facts_of(reply[2]), facts_of(reply[3])};
  // Facts that the domain says always hold are not seen, and need no watching.
  const std::vector<Datum>& always = domain_.domain().facts;
  for (const Datum& fact : always) {
    next.needed.erase(fact);
    next.needed_after.erase(fact);
  }
  for (const Datum& operation : reply[1].items()) {
    Result<GroundOperation> ground = domain_.ground(operation);
    // A plan in terms of another domain file is none.
    if (!ground) return fail("off-plan", ground.error().sentence, operation);
    std::erase_if(ground->preconditions,
                  [&](const Datum& fact) { return std::ranges::find(always, fact) != always.end(); });
    next.rest.push_back(std::move(*ground));
  }
  return next;
}

}  // namespace pizarra::coordinator
