// The commands that know what a cell of agents is about: goals, plans, who is there.

#include <fmt/format.h>

#include "agents/repl/commands.hpp"
#include "agents/repl/json_answers.hpp"
#include "agents/repl/why_fact.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/forms/goal.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/reader.hpp"
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

Task<Evaluation> Interpreter::goal(Datum form) {
  if (form.size() < 2) co_return usage("goal");
  const Result<std::string> coordinator = co_await present_coordinator("would pursue a goal");
  if (!coordinator) co_return show(coordinator.error());
  const bool early = co_await being_taught();
  if (early) {
    const Failure early_goal{
        "not-ready", "the objects are still being taught; (ask (person done ?)) says yes when they are", {}, {}};
    co_return show(early_goal, Evaluation::refused);
  }
  // A fact of the board, as a request is one, holds no variables.
  const Datum wanted = forms::without_variables(form);
  const Result<Datum> accepted = co_await caller_.call(*coordinator, wanted, accept_timeout);
  if (!accepted) {
    const bool text = !accepted.error().place.empty();
    co_return show(accepted.error(), text ? Evaluation::malformed : Evaluation::failed);
  }
  const Datum number = accepted->size() == 1 ? (*accepted)[0] : Datum();
  say(fmt::format("goal {} accepted", write(number)),
      fmt::format("{{\"goal\":{},\"state\":\"accepted\"}}", write(number)));
  if (patience_ == Patience::accepted) co_return Evaluation::done;
  std::string typed;
  for (const Datum& fact : form.items().subspan(1)) typed += (typed.empty() ? "" : " ") + write(fact);
  const Evaluation outcome = co_await wait_for_end(number, std::move(typed));
  co_return outcome;
}

Task<Evaluation> Interpreter::wait_for_end(Datum number, std::string typed) {
  const Datum state = list("goal-state"_sym, number, "?state"_sym, "?detail"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(query_for(state));
  if (!watch) co_return show(watch.error());
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return show(change.error());
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
void Interpreter::say_end(const Datum& state, const std::string& typed) {
  const bool failed = state[3].is_form("fail");
  const Failure failure = failed ? forms::at_its_goal(failure_from_datum(state[3]), typed) : Failure();
  say(fmt::format("goal {} {}{}", write(state[1]), state[2].text(), failed ? ": " + describe(failure) : ""),
      fmt::format("{{\"goal\":{},\"state\":\"{}\"{}}}", write(state[1]), state[2].text(),
                  failed ? ",\"error\":" + json_failure(failure) : ""));
}

// While the person of the cell teaches its objects few are known yet.
Task<bool> Interpreter::being_taught() {
  const Result<std::vector<Fact>> person = co_await context_.board.facts(read_pattern("(agent ? person ?)"));
  if (!person || person->empty()) co_return false;
  const Result<std::vector<Fact>> says =
      co_await runtime::facts_if_declared(context_.board, read_pattern("(person ? ?)"));
  if (!says || says->empty()) co_return true;
  co_return says->front().datum[1].is_symbol("teaching");
}

Task<Evaluation> Interpreter::cancel(Datum form) {
  const std::string coordinator = co_await serving(runtime::coordinator_role());
  const Evaluation outcome = co_await request(coordinator, form);
  co_return outcome;
}

Task<Evaluation> Interpreter::why_fact(Datum pattern) {
  const Result<std::vector<std::string>> lines = co_await why_facts(context_.board, pattern);
  if (!lines) co_return show(lines.error());
  if (style_ == Style::json) {
    std::vector<Datum> texts;
    for (const std::string& line : *lines) texts.push_back(Datum::string(line));
    output_(fmt::format("{{\"why\":{}}}", json_values(texts)));
    co_return Evaluation::done;
  }
  if (lines->empty()) output_(fmt::format("{} does not hold", write(pattern)));
  for (const std::string& line : *lines) output_(line);
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::why(Datum form) {
  const bool is_why_not = form.size() > 2 && form[1].is_symbol("not");
  if (form.size() > 2 && !is_why_not) co_return usage("why");
  if (form.size() == 2) {
    const Evaluation shown = co_await why_fact(form[1]);
    co_return shown;
  }
  const Result<std::string> coordinator = co_await present_coordinator("knows why");
  if (!coordinator) co_return show(coordinator.error());
  const bool of_a_goal = form.size() > 2;
  const Datum asked = of_a_goal ? why_not_of(form) : form;
  const Evaluation outcome = co_await request(*coordinator, asked);
  co_return outcome;
}

Task<Evaluation> Interpreter::plan(Datum) {
  const Result<std::vector<Fact>> plans =
      co_await runtime::facts_if_declared(context_.board, read_pattern("(plan ?n ?operations)"));
  if (!plans) co_return show(plans.error());
  const Result<std::vector<Fact>> in_hand =
      co_await runtime::facts_if_declared(context_.board, read_pattern("(operation ?i ?operation ?state)"));
  if (!in_hand) co_return show(in_hand.error());
  if (plans->empty()) output_("no plan");
  for (const Fact& plan : *plans) {
    output_(fmt::format("plan for goal {}:", write(plan.datum[1])));
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
      output_(mark.empty() ? fmt::format("  {:>2}  {}", index + 1, text)
                           : fmt::format("  {:>2}  {:30} {}", index + 1, text, mark));
      ++index;
    }
  }
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::agents(Datum) {
  const Result<std::vector<Fact>> present = co_await context_.board.facts(read_pattern("(agent ? ? ?)"));
  if (!present) co_return show(present.error());
  for (const Fact& agent : *present) {
    output_(fmt::format("  {} ({}) on {}", agent.datum[1].text(), agent.datum[2].text(), agent.datum[3].text()));
    const std::vector<Datum> offers = co_await offers_of(agent.datum[1]);
    for (const Datum& operation : offers) output_("      " + write(operation));
  }
  co_return Evaluation::done;
}

Task<std::vector<Datum>> Interpreter::offers_of(Datum agent) {
  const Result<std::vector<Fact>> contracts = co_await context_.board.facts(list("contract"_sym, agent, "?"_sym));
  std::vector<Datum> out;
  for (const Fact& contract : contracts.value_or(std::vector<Fact>())) {
    for (const Datum& part : contract.datum[2].items()) {
      if (!part.is_form("offers")) continue;
      out.insert(out.end(), part.items().begin() + 1, part.items().end());
    }
  }
  co_return out;
}

// Names for completion: what cannot be learned now keeps its old names.
Task<void> Interpreter::learn_words() {
  const Result<std::vector<Fact>> contracts = co_await context_.board.facts(read_pattern("(contract ?name ?form)"));
  for (const Fact& fact : contracts.value_or(std::vector<Fact>())) {
    words_.emplace(fact.datum[1].text());
    for (const Datum& part : fact.datum[2].items()) {
      if (!part.is_list()) continue;
      for (const Datum& item : part.items()) {
        if (part.is_form("offers") && item.is_list()) words_.emplace(item.head());
        if (item.is_form("relation") && item.size() > 1) words_.emplace(item[1].text());
      }
    }
  }
  const Result<std::vector<Fact>> learned =
      co_await runtime::facts_if_declared(context_.board, read_pattern("(learned ? ? ? ? ? ? ? ? ?)"));
  for (const Fact& fact : learned.value_or(std::vector<Fact>())) words_.emplace(fact.datum[2].text());
}

}  // namespace pizarra::repl
