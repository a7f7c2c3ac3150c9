#include "agents/repl/goal_commands.hpp"

#include <fmt/format.h>

#include "agents/repl/agent_commands.hpp"
#include "agents/repl/answer_text.hpp"
#include "agents/repl/role_commands.hpp"
#include "agents/repl/why_fact.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/forms/goal.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

constexpr Duration accept_timeout = 120s;

// (why not GOAL ...) as the coordinator is asked it.
Datum why_not_of(const Datum& form) {
  std::vector<Datum> items{"why-not"_sym};
  for (const Datum& part : form.items().subspan(2)) items.push_back(forms::without_variables(part));
  return Datum::list(std::move(items));
}

}  // namespace

Task<Evaluation> GoalCommands::goal(Typed typed) {
  if (typed.form.size() < 2) co_return prompt_.misused(typed);
  const Result<std::string> coordinator = co_await present_coordinator(prompt_.context, "would pursue a goal");
  if (!coordinator) co_return prompt_.show(coordinator.error());
  const bool early = co_await being_taught();
  if (early) {
    const Failure early_goal{
        "not-ready", "the objects are still being taught; (ask (person done ?)) says yes when they are", {}, {}};
    co_return prompt_.show(early_goal, Evaluation::refused);
  }
  // A fact of the board, as a request is one, holds no variables.
  const Datum wanted = forms::without_variables(typed.form);
  const Result<Datum> accepted = co_await prompt_.caller.call(*coordinator, wanted, accept_timeout);
  if (!accepted) {
    const bool text = !accepted.error().place.empty();
    co_return prompt_.show(accepted.error(), text ? Evaluation::malformed : Evaluation::failed);
  }
  const Datum number = accepted->size() == 1 ? (*accepted)[0] : Datum();
  prompt_.say(fmt::format("goal {} accepted", write(number)),
              fmt::format("{{\"goal\":{},\"state\":\"accepted\"}}", write(number)));
  if (patience_ == Patience::accepted) co_return Evaluation::done;
  std::string facts;
  for (const Datum& fact : typed.form.items().subspan(1)) facts += (facts.empty() ? "" : " ") + write(fact);
  co_return co_await wait_for_end(number, std::move(facts));
}

Task<Evaluation> GoalCommands::wait_for_end(Datum number, std::string typed) {
  const Datum state = list("goal-state"_sym, number, "?state"_sym, "?detail"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await prompt_.board.watch(query_for(state));
  if (!watch) co_return prompt_.show(watch.error());
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return prompt_.show(change.error());
    for (const Answer& answer : change->added) {
      const Datum& fact = answer.facts.front().datum;
      if (fact[2].is_symbol("running")) continue;
      say_end(fact, typed);
      if (fact[2].is_symbol("refused")) co_return Evaluation::refused;
      const bool is_so = fact[2].is_symbol("reached") || fact[2].is_symbol("kept");
      co_return is_so ? Evaluation::done : Evaluation::failed;
    }
  }
}

// `(goal-state N STATE DETAIL)`
void GoalCommands::say_end(const Datum& state, const std::string& typed) {
  const bool failed = state[3].is_form("fail");
  const Failure failure = failed ? forms::at_its_goal(failure_from_datum(state[3]), typed) : Failure();
  prompt_.say(fmt::format("goal {} {}{}", write(state[1]), state[2].text(), failed ? ": " + describe(failure) : ""),
              fmt::format("{{\"goal\":{},\"state\":\"{}\"{}}}", write(state[1]), state[2].text(),
                          failed ? ",\"error\":" + json_failure(failure) : ""));
}

// While the person of the cell teaches its objects few are known yet.
Task<bool> GoalCommands::being_taught() {
  const Result<std::vector<Fact>> person = co_await prompt_.board.facts(read_pattern("(agent ? person ?)"));
  if (!person || person->empty()) co_return false;
  const Result<std::vector<Fact>> says =
      co_await runtime::facts_if_declared(prompt_.board, read_pattern("(person ? ?)"));
  if (!says || says->empty()) co_return true;
  co_return says->front().datum[1].is_symbol("teaching");
}

Task<Evaluation> GoalCommands::cancel(Typed typed) {
  const std::string coordinator = co_await coordinator_of_prompts(prompt_.board);
  co_return co_await ask_agent(prompt_, coordinator, typed.form);
}

Task<Evaluation> GoalCommands::why_fact(Datum pattern) {
  const Result<std::vector<std::string>> lines = co_await why_facts(prompt_.board, pattern);
  if (!lines) co_return prompt_.show(lines.error());
  if (prompt_.style == Style::json) {
    std::vector<Datum> texts;
    for (const std::string& line : *lines) texts.push_back(Datum::string(line));
    prompt_.print(fmt::format("{{\"why\":{}}}", json_values(texts)));
    co_return Evaluation::done;
  }
  if (lines->empty()) prompt_.print(fmt::format("{} does not hold", write(pattern)));
  for (const std::string& line : *lines) prompt_.print(line);
  co_return Evaluation::done;
}

Task<Evaluation> GoalCommands::why(Typed typed) {
  const bool is_why_not = typed.form.size() > 2 && typed.form[1].is_symbol("not");
  if (typed.form.size() > 2 && !is_why_not) co_return prompt_.misused(typed);
  if (typed.form.size() == 2) {
    const Evaluation shown = co_await why_fact(typed.form[1]);
    co_return shown;
  }
  const Result<std::string> coordinator = co_await present_coordinator(prompt_.context, "knows why");
  if (!coordinator) co_return prompt_.show(coordinator.error());
  const bool of_a_goal = typed.form.size() > 2;
  const Datum asked = of_a_goal ? why_not_of(typed.form) : typed.form;
  co_return co_await ask_agent(prompt_, *coordinator, asked);
}

Task<Evaluation> GoalCommands::plan(Typed) {
  const Result<std::vector<Fact>> plans =
      co_await runtime::facts_if_declared(prompt_.board, read_pattern("(plan ?n ?operations)"));
  if (!plans) co_return prompt_.show(plans.error());
  const Result<std::vector<Fact>> in_hand =
      co_await runtime::facts_if_declared(prompt_.board, read_pattern("(operation ?i ?operation ?state)"));
  if (!in_hand) co_return prompt_.show(in_hand.error());
  if (plans->empty()) prompt_.print("no plan");
  for (const Fact& plan : *plans) {
    prompt_.print(fmt::format("plan for goal {}:", write(plan.datum[1])));
    std::int64_t index = 0;
    for (const Datum& operation : plan.datum[2].items()) {
      // The one in hand says how it stands; those before it are behind us.
      std::string_view mark;
      for (const Fact& fact : *in_hand) {
        const std::int64_t at = fact.datum[1].integer();
        if (index < at) mark = "done";
        if (index == at) mark = fact.datum[3].text();
      }
      const std::string text = write(operation);
      prompt_.print(mark.empty() ? fmt::format("  {:>2}  {}", index + 1, text)
                                 : fmt::format("  {:>2}  {:30} {}", index + 1, text, mark));
      ++index;
    }
  }
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
