// What a page wants done: requests to agents, goals, stops, and the arm in its operator's hands.

#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/session.hpp"
#include "agents/console/wiring.hpp"
#include "agents/runtime/declared.hpp"
#include "agents/runtime/roles.hpp"
#include "lisp/forms/goal.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::console {

namespace {

constexpr Duration request_timeout = 120s;

const Datum any = "?"_sym;

Datum commander_of(const Datum& robot, const Datum& client) { return list("commander"_sym, robot, client); }

Relation stop_relation() {
  return relation_from_datum(read_one("(relation stop ((who symbol) (reason string)) (key who) (durable))").value())
      .value();
}

Datum wish(const Datum& robot, const std::string& client) {
  return list("commander-wanted"_sym, robot, Datum::symbol(client));
}

// The facts that a person typed: alone, or within the `goal` that a prompt wants around them.
Result<Datum> goal_form(const std::string& text) {
  const ReadLimits limits{.bytes = WebSocket::max_message, .depth = 32, .elements = 4000};
  const Result<Source> source = read_source(text, "goal", limits);
  if (!source) return fail(source);
  const std::vector<Datum>& typed = source->data();
  if (typed.empty()) return fail("malformed", "nothing is typed: a goal is FACT, (and FACT ...) or several FACTs");
  if (typed.size() == 1 && typed.front().is_form("goal")) return typed.front();
  std::vector<Datum> form{"goal"_sym};
  form.insert(form.end(), typed.begin(), typed.end());
  return Datum::list(std::move(form));
}

}  // namespace

bool Session::begin_request(Number number, Task<void> task) {
  std::erase_if(requests_, [](const auto& entry) { return entry.second.done(); });
  if (requests_.size() >= max_requests) {
    voice_.refuse(number, "too-many", fmt::format("{} requests are in hand already", max_requests));
    return false;
  }
  if (requests_.contains(number)) {
    voice_.refuse(number, "malformed", "a request of that number is in hand");
    return false;
  }
  requests_.emplace(number, setup_.executor.spawn(std::move(task)));
  return true;
}

void Session::request(const Datum& form) {
  begin_request(form[1].integer(), ask_agent(form[1].integer(), std::string(form[2].text()), form[3]));
}

// A page is told who plays the other roles, as it follows what those tell.
Task<void> Session::ask_agent(Number number, std::string agent, Datum operation) {
  const runtime::Role role = runtime::coordinator_role();
  if (agent == role.name) {
    const Result<runtime::Holder> holder = co_await runtime::holder_of(context_.board, Wiring::client, role);
    if (holder) agent = holder->server;
  }
  const Result<Datum> answer = co_await answer_of(std::move(agent), std::move(operation));
  voice_.say(answer ? reply_text(number, *answer) : refusal_text(number, answer.error()));
}

Task<Result<Datum>> Session::answer_of(std::string agent, Datum operation) {
  const Datum presence = list("agent"_sym, Datum::symbol(agent), any, any);
  const Result<std::vector<Fact>> present = co_await context_.board.facts(presence);
  const bool there = present && !present->empty();
  if (!there) co_return fail("absent", fmt::format("no agent {} is present", agent));
  Result<Datum> answer = co_await caller_.call(agent, operation, request_timeout);
  co_return answer;
}

void Session::goal(const Datum& form) {
  begin_request(form[1].integer(), pursue(form[1].integer(), std::string(form[2].text())));
}

Task<void> Session::pursue(Number number, std::string text) {
  const Result<Datum> form = goal_form(text);
  if (!form) {
    voice_.say(refusal_text(number, form.error()));
    co_return;
  }
  const bool early = co_await being_taught();
  if (early) {
    voice_.refuse(number, "not-ready", "the objects are still being taught");
    co_return;
  }
  const runtime::Role role = runtime::coordinator_role();
  const Result<runtime::Holder> coordinator = co_await runtime::present_holder_of(context_, Wiring::client, role);
  if (!coordinator || !coordinator->is_present()) {
    voice_.refuse(number, "absent", "no coordinator is present, so nobody would pursue a goal");
    co_return;
  }
  // A fact of the board, as a request is one, holds no variables.
  const Datum wanted = forms::without_variables(*form);
  const Result<Datum> accepted = co_await caller_.call(coordinator->server, wanted, request_timeout);
  if (!accepted) {
    voice_.say(refusal_text(number, accepted.error()));
    co_return;
  }
  voice_.say(reply_text(number, *accepted));
  if (accepted->size() == 1) co_await say_end_of_goal(number, (*accepted)[0], std::move(text));
}

Task<void> Session::say_end_of_goal(Number number, Datum goal, std::string text) {
  const Datum state = list("goal-state"_sym, goal, "?state"_sym, "?detail"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(query_for(state));
  if (!watch) co_return;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) {
      const Datum& fact = answer.facts.front().datum;
      if (fact[2].is_symbol("running")) continue;
      const bool failed = fact[3].is_form("fail");
      const Datum ended = list(fact[2]);
      voice_.say(failed ? refusal_text(number, forms::at_its_goal(failure_from_datum(fact[3]), text))
                        : reply_text(number, ended));
      co_return;
    }
  }
}

// While the person of the cell teaches its objects few are known yet.
Task<bool> Session::being_taught() {
  const Datum person = list("agent"_sym, any, "person"_sym, any);
  const Result<std::vector<Fact>> there = co_await context_.board.facts(person);
  if (!there || there->empty()) co_return false;
  const Datum says = list("person"_sym, any, any);
  const Result<std::vector<Fact>> told = co_await runtime::facts_if_declared(context_.board, says);
  if (!told || told->empty()) co_return true;
  co_return told->front().datum[1].is_symbol("teaching");
}

// Never behind other requests, and whatever their number. It comes two ways, and counts once: where the slower one
// brings it after somebody has cleared it, it stops nothing anew.
void Session::stop(const Datum& form) {
  const Number number = form[1].integer();
  if (number <= newest_stop_) return;
  newest_stop_ = number;
  stopping_.push_back(setup_.executor.spawn(tell_stop(number, std::string(form[2].text()))));
  std::erase_if(stopping_, [](const Job& job) { return job.done(); });
}

Task<void> Session::tell_stop(Number number, std::string reason) {
  const Datum fact = list("stop"_sym, Datum::symbol(setup_.name), reason);
  Result<Revision> told = co_await context_.board.tell(fact);
  // It stands also for a robot that is yet to come.
  if (!told && told.error().symbol == "undeclared-relation") {
    const std::vector<Relation> relations(1, stop_relation());
    const Result<void> declared = co_await context_.board.declare(relations);
    if (declared) told = co_await context_.board.tell(fact);
  }
  told = if_it_stands(std::move(told));
  const Datum done;
  voice_.say(told ? reply_text(number, done) : refusal_text(number, told.error()));
}

// Only who has an arm in hand may set arms free.
void Session::clear_stops(const Datum& form) {
  Transaction transaction;
  transaction.require(Transaction::Present{commander_of(any, Datum::symbol(setup_.name))});
  transaction.retract(list("stop"_sym, any, any));
  const Failure otherwise{"not-commander", "take an arm in hand first: who clears a stop sets it free", {}, {}};
  begin_request(form[1].integer(), change_board(form[1].integer(), std::move(transaction), otherwise));
}

void Session::command(const Datum& form) {
  Transaction transaction;
  transaction.require(Transaction::Absent{commander_of(form[2], any)});
  transaction.tell(commander_of(form[2], Datum::symbol(setup_.name)), {}, service_.presence());
  const Failure otherwise{"in-other-hands", "another has this arm in hand: take it over, or wait", {}, {}};
  begin_request(form[1].integer(), change_board(form[1].integer(), std::move(transaction), otherwise));
}

void Session::take_over(const Datum& form) {
  Transaction transaction;
  transaction.retract(commander_of(form[2], any));
  transaction.tell(commander_of(form[2], Datum::symbol(setup_.name)), {}, service_.presence());
  begin_request(form[1].integer(), change_board(form[1].integer(), std::move(transaction), {}));
}

void Session::let_go(const Datum& form) {
  Transaction transaction;
  transaction.retract(commander_of(form[2], Datum::symbol(setup_.name)));
  begin_request(form[1].integer(), change_board(form[1].integer(), std::move(transaction), {}));
}

void Session::ask_for(const Datum& form) {
  Transaction transaction;
  transaction.tell(wish(form[2], setup_.name), {}, service_.presence());
  begin_request(form[1].integer(), change_board(form[1].integer(), std::move(transaction), {}));
}

void Session::ask_no_more(const Datum& form) {
  Transaction transaction;
  transaction.retract(wish(form[2], setup_.name));
  begin_request(form[1].integer(), change_board(form[1].integer(), std::move(transaction), {}));
}

// Before anybody follows them. A page that may not tell any is refused when it does.
Task<void> Session::declare_wishes() {
  const char* const wishes = "(relation commander-wanted ((robot symbol) (client symbol)) (key robot client))";
  const std::vector<Relation> relations(1, relation_from_datum(read_one(wishes).value()).value());
  [[maybe_unused]] const Result<void> declared = co_await context_.board.declare(relations);
}

// `otherwise`: what is said where a precondition does not hold.
Task<void> Session::change_board(Number number, Transaction transaction, Failure otherwise) {
  Result<Revision> changed = co_await context_.board.transact(std::move(transaction));
  changed = if_it_stands(std::move(changed));
  const Datum done;
  if (changed) {
    voice_.say(reply_text(number, done));
  } else {
    const bool unmet = changed.error().symbol == "precondition-failed";
    voice_.say(refusal_text(number, unmet ? otherwise : changed.error()));
  }
}

}  // namespace pizarra::console
