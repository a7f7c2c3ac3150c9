#include "agents/runtime/roles.hpp"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <span>

#include "agents/runtime/declared.hpp"
#include "agents/runtime/naming.hpp"
#include "blackboard/away.hpp"
#include "lisp/reader.hpp"

namespace pizarra::runtime {

namespace {

// How often it is seen whether the client's presence began anew, and what stood under it has to be told again.
constexpr Duration holder_look = 1s;
const Datum anything = "?"_sym;

using Kinds = std::map<std::string, std::string>;

Holder choose_holder(const Role& role, const std::string& wired, const Kinds& kinds,
                     std::span<const std::string> line) {
  const auto can = [&](const std::string& agent) {
    const auto found = kinds.find(agent);
    return found != kinds.end() && found->second == role.kind;
  };
  if (can(wired)) return {wired, "wired"};
  std::vector<std::string> able;
  for (const std::string& agent : line) {
    if (agent != wired && can(agent)) able.push_back(agent);
  }
  if (able.empty()) return {wired, "absent"};
  std::ranges::sort(able);
  const auto next = std::ranges::upper_bound(able, wired);
  return {next == able.end() ? able.front() : *next, "stands-in"};
}

Datum context_of(const Role& role) { return list("cell"_sym, Datum::symbol(role.context)); }
Datum any_agent() { return list("agent"_sym, anything, anything, anything); }
Datum wired_pattern(const std::string& client) { return list("wired"_sym, Datum::symbol(client), anything, anything); }
Datum bound_pattern(Datum context) { return list("bound"_sym, std::move(context), anything, anything, anything); }

}  // namespace

Role robot_role() { return {"robot", "robot", "arms", "robot"}; }
Role eyes_role() { return {"eyes", "vision", "eyes", "vision"}; }
Role planner_role() { return {"planner", "planner", "planners", "planner"}; }
Role coordinator_role() { return {"coordinator", "coordinator", "coordinators", "coordinator"}; }

std::vector<Relation> role_relations() {
  constexpr std::string_view forms[] = {
      "(relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))",
      "(relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role))",
  };
  std::vector<Relation> relations;
  for (const std::string_view form : forms) relations.push_back(relation_from_datum(read_one(form).value()).value());
  return relations;
}

Roles::Roles(AgentContext& context, const Service& service, std::vector<Role> roles)
    : context_(context), service_(service), changed_(context.executor) {
  for (Role& role : roles) {
    Holder usual{role.usual, "absent"};
    std::string wired = role.usual;
    played_.push_back({std::move(role), std::move(wired), std::move(usual)});
  }
}

void Roles::start() { beginning_ = context_.executor.spawn(begin()); }

// Where its key does not let it declare or tell these, it is served by the usual agents.
Task<void> Roles::begin() {
  std::vector<Relation> relations = naming_relations();
  const std::vector<Relation> of_roles = role_relations();
  relations.insert(relations.end(), of_roles.begin(), of_roles.end());
  Result<void> declared = co_await context_.board.declare(relations);
  while (!declared && is_away(declared.error())) {
    co_await sleep(context_.executor, retry_pause);
    declared = co_await context_.board.declare(relations);
  }
  for (const Played& played : played_) {
    const Datum client = Datum::symbol(context_.name), role = Datum::symbol(played.role.name);
    Transaction wiring;
    const Transaction::Absent not_wired{list("wired"_sym, client, role, anything)};
    wiring.require(not_wired);
    wiring.tell(list("wired"_sym, client, role, Datum::symbol(played.role.usual)));
    [[maybe_unused]] const Result<Revision> told = co_await context_.board.transact(std::move(wiring));
  }
  unanswered_ = 3;
  jobs_.push_back(context_.executor.spawn(follow(any_agent(), &Roles::take_agent)));
  jobs_.push_back(context_.executor.spawn(follow(bound_pattern(anything), &Roles::take_bound)));
  jobs_.push_back(context_.executor.spawn(follow(wired_pattern(context_.name), &Roles::take_wired)));
  jobs_.push_back(context_.executor.spawn(keep_told()));
}

Task<void> Roles::follow(Datum pattern, Take take) {
  const Query query = query_for(std::move(pattern));
  bool answered = false;
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await watch_when_declared(context_.board, query);
    const bool refused = !watch && watch.error().symbol == "not-permitted";
    if (refused) break;
    while (watch) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      if (change->resynchronised) forget_all(take);
      for (const Answer& answer : change->removed) (this->*take)(answer.facts.front().datum, false);
      for (const Answer& answer : change->added) (this->*take)(answer.facts.front().datum, true);
      if (!answered) --unanswered_;
      answered = true;
      choose();
    }
    co_await sleep(context_.executor, retry_pause);
  }
  if (!answered) --unanswered_;
  choose();
}

void Roles::forget_all(Take take) {
  if (take == &Roles::take_agent) kinds_.clear();
  if (take == &Roles::take_bound) bound_.clear();
  if (take != &Roles::take_wired) return;
  for (Played& played : played_) played.wired = played.role.usual;
}

void Roles::take_agent(const Datum& fact, bool stands) {
  const std::string name(fact[1].text());
  if (stands) {
    kinds_[name] = fact[2].text();
  } else {
    kinds_.erase(name);
  }
}

void Roles::take_bound(const Datum& fact, bool stands) {
  for (Played& played : played_) {
    if (fact[1] != context_of(played.role)) continue;
    std::vector<std::string>& line = bound_[played.role.context];
    const std::string agent(fact[4].text());
    if (stands) {
      line.push_back(agent);
    } else if (const auto gone = std::ranges::find(line, agent); gone != line.end()) {
      line.erase(gone);
    }
    return;
  }
}

void Roles::take_wired(const Datum& fact, bool stands) {
  for (Played& played : played_) {
    if (!fact[2].is_symbol(played.role.name)) continue;
    played.wired = stands ? std::string(fact[3].text()) : played.role.usual;
  }
}

void Roles::choose() {
  if (unanswered_ > 0) return;
  bool other = false;
  for (Played& played : played_) {
    Holder now = choose_holder(played.role, played.wired, kinds_, bound_[played.role.context]);
    other = other || now != played.holder;
    played.holder = std::move(now);
  }
  if (other) changed_.wake_all();
}

const Holder& Roles::holder(std::string_view role) const {
  const auto found = std::ranges::find_if(played_, [&](const Played& played) { return played.role.name == role; });
  assert(found != played_.end() && "a client asks for roles that it was made with");
  return found->holder;
}

Task<bool> Roles::wait_for(std::string role, Time deadline) {
  while (!holder(role).is_present()) {
    const bool woken = co_await changed_.wait(deadline);
    if (!woken) co_return holder(role).is_present();
  }
  co_return true;
}

Callee Roles::player(std::string role) const {
  const std::string& server = holder(role).server;
  return {server, [this, role = std::move(role), server] {
            const Holder& now = holder(role);
            return now.server != server && now.is_present() && !kinds_.contains(server);
          }};
}

Task<void> Roles::keep_told() {
  std::vector<Holder> told;
  LeaseId told_under = 0;
  while (true) {
    std::vector<Holder> holders;
    for (const Played& played : played_) holders.push_back(played.holder);
    const LeaseId presence = service_.presence();
    const bool settled = unanswered_ == 0;
    const bool known = told == holders && told_under == presence;
    if (settled && !known) {
      Transaction telling;
      for (const Played& played : played_) {
        telling.tell(list("holder"_sym, Datum::symbol(context_.name), Datum::symbol(played.role.name),
                          Datum::symbol(played.holder.server), Datum::symbol(played.holder.state)),
                     {}, presence);
      }
      const Result<Revision> stands = co_await context_.board.transact(std::move(telling));
      const bool refused = !stands && stands.error().symbol == "not-permitted";
      if (refused) co_return;
      if (stands) {
        told = std::move(holders);
        told_under = presence;
      }
    }
    const Time look_up = context_.executor.now() + holder_look;
    co_await changed_.wait(look_up);
  }
}

Task<Result<Holder>> holder_of(Board& board, std::string client, Role role) {
  const Datum wiring = list("wired"_sym, Datum::symbol(client), Datum::symbol(role.name), anything);
  const Result<std::vector<Fact>> wired = co_await facts_if_declared(board, wiring);
  if (!wired) co_return fail(wired);
  const Result<std::vector<Fact>> agents = co_await facts_if_declared(board, any_agent());
  if (!agents) co_return fail(agents);
  const Datum line = bound_pattern(context_of(role));
  const Result<std::vector<Fact>> bound = co_await facts_if_declared(board, line);
  Kinds kinds;
  for (const Fact& fact : *agents) kinds.emplace(fact.datum[1].text(), fact.datum[2].text());
  std::vector<std::string> names;
  for (const Fact& fact : bound.value_or(std::vector<Fact>())) names.emplace_back(fact.datum[4].text());
  const std::string server = wired->empty() ? role.usual : std::string(wired->front().datum[3].text());
  co_return choose_holder(role, server, kinds, names);
}

Task<Result<Holder>> present_holder_of(AgentContext& context, std::string client, Role role) {
  const Time deadline = context.executor.now() + Presence::lease_length;
  while (true) {
    const Result<Holder> holder = co_await holder_of(context.board, client, role);
    const bool settled = !holder || holder->is_present() || context.executor.now() >= deadline;
    if (settled) co_return holder;
    co_await sleep(context.executor, Presence::renewal / 5);
  }
}

}  // namespace pizarra::runtime
