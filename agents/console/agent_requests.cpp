#include "agents/console/agent_requests.hpp"

#include "agents/console/change_text.hpp"
#include "agents/console/wiring.hpp"
#include "agents/runtime/declared.hpp"
#include "agents/runtime/roles.hpp"
#include "lisp/forms/goal.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

// The facts that a person typed: alone, or within the `goal` that a prompt wants around them.
Result<Datum> goal_form(const std::string& text) {
  const ReadLimits limits{.bytes = web::WebSocket::max_message, .depth = 32, .elements = 4000};
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

void AgentRequests::request(const Datum& form) {
  requests_.begin(form[1].integer(), ask(form[1].integer(), std::string(form[2].text()), form[3]));
}

// A page is told who plays the other roles, as it follows what those tell.
Task<void> AgentRequests::ask(std::int64_t number, std::string agent, Datum operation) {
  const runtime::Role role = runtime::coordinator_role();
  if (agent == role.name) {
    const Result<runtime::Holder> holder = co_await runtime::holder_of(board_.facts(), Wiring::client, role);
    if (holder) agent = holder->server;
  }
  const Result<Datum> answer = co_await board_.call(std::move(agent), std::move(operation));
  voice_.say(answer ? reply_text(number, *answer) : refusal_text(number, answer.error()));
}

void AgentRequests::goal(const Datum& form) {
  requests_.begin(form[1].integer(), pursue(form[1].integer(), std::string(form[2].text())));
}

Task<void> AgentRequests::pursue(std::int64_t number, std::string text) {
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
  const Result<runtime::Holder> coordinator =
      co_await runtime::present_holder_of(board_.context(), Wiring::client, role);
  if (!coordinator || !coordinator->is_present()) {
    voice_.refuse(number, "absent", "no coordinator is present, so nobody would pursue a goal");
    co_return;
  }
  // A fact of the board, as a request is one, holds no variables.
  const Datum wanted = forms::without_variables(*form);
  const Result<Datum> accepted = co_await board_.call(coordinator->server, wanted);
  if (!accepted) {
    voice_.say(refusal_text(number, accepted.error()));
    co_return;
  }
  voice_.say(reply_text(number, *accepted));
  if (accepted->size() == 1) co_await say_end_of_goal(number, (*accepted)[0], std::move(text));
}

Task<void> AgentRequests::say_end_of_goal(std::int64_t number, Datum goal, std::string text) {
  const Datum state = list("goal-state"_sym, goal, "?state"_sym, "?detail"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await board_.facts().watch(query_for(state));
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
Task<bool> AgentRequests::being_taught() {
  const Datum person = list("agent"_sym, "?"_sym, "person"_sym, "?"_sym);
  const Result<std::vector<Fact>> there = co_await board_.facts().facts(person);
  if (!there || there->empty()) co_return false;
  const Datum says = list("person"_sym, "?"_sym, "?"_sym);
  const Result<std::vector<Fact>> told = co_await runtime::facts_if_declared(board_.facts(), says);
  if (!told || told->empty()) co_return true;
  co_return told->front().datum[1].is_symbol("teaching");
}

}  // namespace pizarra::console
