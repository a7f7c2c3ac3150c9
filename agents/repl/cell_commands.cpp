// The commands that know what a cell of agents is about: goals, plans, objects.

#include <fmt/format.h>
#include <set>

#include "agents/repl/commands.hpp"
#include "agents/repl/json_answers.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/forms/goal.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr Duration accept_timeout = 120s;

Datum pattern(std::string_view text) { return read_one(text).value(); }

}  // namespace

Task<Evaluation> Interpreter::goal(Datum form) {
  if (form.size() < 2) co_return usage("goal");
  const bool pursued = co_await is_agent("coordinator");
  if (!pursued) {
    const Failure alone{
        "absent", "no coordinator is present, so nobody would pursue a goal; (agents) shows who is", {}, {}};
    co_return show(alone);
  }
  const bool early = co_await being_taught();
  if (early) {
    const Failure early_goal{
        "not-ready", "the objects are still being taught; (ask (person done ?)) says yes when they are", {}, {}};
    co_return show(early_goal, Evaluation::refused);
  }
  const Result<Datum> accepted = co_await caller_.call("coordinator", form, accept_timeout);
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
      co_return fact[2].is_symbol("reached") ? Evaluation::done : Evaluation::failed;
    }
  }
}

// `(goal-state N STATE DETAIL)`
void Interpreter::say_end(const Datum& state, const std::string& typed) {
  const bool failed = state[3].is_form("fail");
  const Failure failure = failed ? at_its_goal(failure_from_datum(state[3]), typed) : Failure();
  say(fmt::format("goal {} {}{}", write(state[1]), state[2].text(), failed ? ": " + describe(failure) : ""),
      fmt::format("{{\"goal\":{},\"state\":\"{}\"{}}}", write(state[1]), state[2].text(),
                  failed ? ",\"error\":" + json_failure(failure) : ""));
}

// While the person of the cell teaches its objects few are known yet.
Task<bool> Interpreter::being_taught() {
  const Result<std::vector<Fact>> person = co_await context_.board.facts(pattern("(agent ? person ?)"));
  if (!person || person->empty()) co_return false;
  const Result<std::vector<Fact>> says = co_await facts_if_declared(context_.board, pattern("(person ? ?)"));
  if (!says || says->empty()) co_return true;
  co_return says->front().datum[1].is_symbol("teaching");
}

Task<Evaluation> Interpreter::cancel(Datum form) {
  const Evaluation outcome = co_await request("coordinator", form);
  co_return outcome;
}

Task<Evaluation> Interpreter::why(Datum form) {
  const bool known = co_await is_agent("coordinator");
  if (!known) {
    const Failure alone{"absent", "no coordinator is present, so nobody knows why; (agents) shows who is", {}, {}};
    co_return show(alone);
  }
  const Evaluation outcome = co_await request("coordinator", form);
  co_return outcome;
}

Task<Evaluation> Interpreter::plan(Datum) {
  const Result<std::vector<Fact>> plans = co_await facts_if_declared(context_.board, pattern("(plan ?n ?operations)"));
  if (!plans) co_return show(plans.error());
  const Result<std::vector<Fact>> in_hand =
      co_await facts_if_declared(context_.board, pattern("(operation ?i ?operation ?state)"));
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

Task<Evaluation> Interpreter::objects(Datum) {
  const Result<std::vector<Fact>> learned =
      co_await facts_if_declared(context_.board, pattern("(learned ? ? ? ? ? ? ? ? ?)"));
  if (!learned) co_return show(learned.error());
  const Result<std::vector<Fact>> places = co_await facts_if_declared(context_.board, pattern("(place ? ? ? ? ?)"));
  const Result<std::vector<Fact>> tracking =
      co_await facts_if_declared(context_.board, pattern("(vision-mode ? tracking ?)"));
  const bool followed = tracking && !tracking->empty();
  if (learned->empty()) output_("nothing has been learned");
  std::set<std::string> said;
  for (const Fact& object : *learned) {
    const std::string name(object.datum[2].text());
    if (!said.insert(name).second) continue;
    std::string where = followed ? "not seen" : "learned; it is followed from the first goal on";
    // Without a coordinator nobody says where things are.
    for (const Fact& place : places.value_or(std::vector<Fact>())) {
      if (place.datum[1].text() != name) continue;
      where = fmt::format("x {:.0f}  y {:.0f}  z {:.0f} mm, frame {}", place.datum[2].number(), place.datum[3].number(),
                          place.datum[4].number(), place.datum[5].integer());
    }
    output_(fmt::format("  {:14} {}", name, where));
  }
  const Result<std::vector<Fact>> alike = co_await facts_if_declared(context_.board, pattern("(look-alike ? ? ? ? ?)"));
  for (const Fact& fact : alike.value_or(std::vector<Fact>())) output_(std::string(fact.datum[5].text()));
  const Result<std::vector<Fact>> damaged =
      co_await facts_if_declared(context_.board, pattern("(objects-damaged ? ? ? ?)"));
  for (const Fact& fact : damaged.value_or(std::vector<Fact>())) {
    output_(fmt::format("{}: {}", fact.datum[2].text(), fact.datum[4].text()));
  }
  co_return Evaluation::done;
}

Task<std::vector<Datum>> Interpreter::remarks_on(std::string agent, Datum operation, Datum answer) {
  const bool learns = operation.is_form("learn");
  const bool looks = learns || operation.is_form("find");
  const bool lasts = operation.is_form("track") || operation.is_form("connect");
  const Datum eyes = Datum::symbol(agent);
  std::vector<Datum> out;
  if (lasts) out = co_await remarks_on_mode(eyes);
  if (!looks || answer.size() != 1) co_return out;
  const Datum failed = list("vision-failed"_sym, eyes, "?"_sym, answer[0], "?"_sym, "?"_sym);
  const Result<std::vector<Fact>> failures = co_await facts_if_declared(context_.board, failed);
  for (const Fact& fact : failures.value_or(std::vector<Fact>())) out.push_back(fact.datum[5]);
  if (!learns || !out.empty()) co_return out;
  const Datum& name = operation.items().back();
  const Datum any_alike = list("look-alike"_sym, eyes, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
  const Result<std::vector<Fact>> alike = co_await facts_if_declared(context_.board, any_alike);
  for (const Fact& fact : alike.value_or(std::vector<Fact>())) {
    if (fact.datum[2] == name || fact.datum[3] == name) out.push_back(fact.datum[5]);
  }
  co_return out;
}

// A mode belongs to who asked for it, which here is the prompt.
Task<std::vector<Datum>> Interpreter::remarks_on_mode(Datum eyes) {
  const Datum held = list("vision-held"_sym, eyes, Datum::symbol(context_.name), "?"_sym);
  const Result<std::vector<Fact>> ours = co_await facts_if_declared(context_.board, held);
  std::vector<Datum> out;
  if (!ours || ours->empty()) co_return out;
  const std::string sentence =
      fmt::format("until this prompt ends; ({} (keep)) lets it go on until somebody ends it", eyes.text());
  out.push_back(Datum::string(sentence));
  co_return out;
}

Task<Evaluation> Interpreter::agents(Datum) {
  const Result<std::vector<Fact>> present = co_await context_.board.facts(pattern("(agent ? ? ?)"));
  if (!present) co_return show(present.error());
  const Result<std::vector<Fact>> contracts = co_await context_.board.facts(pattern("(contract ? ?)"));
  if (!contracts) co_return show(contracts.error());
  for (const Fact& agent : *present) {
    output_(fmt::format("  {} ({}) on {}", agent.datum[1].text(), agent.datum[2].text(), agent.datum[3].text()));
    for (const Fact& contract : *contracts) {
      if (contract.datum[1] != agent.datum[1]) continue;
      for (const Datum& part : contract.datum[2].items()) {
        if (!part.is_form("offers")) continue;
        for (const Datum& operation : part.items().subspan(1)) output_("      " + write(operation));
      }
    }
  }
  co_return Evaluation::done;
}

// Names for completion: what cannot be learned now keeps its old names.
Task<void> Interpreter::learn_words() {
  const Result<std::vector<Fact>> contracts = co_await context_.board.facts(pattern("(contract ?name ?form)"));
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
      co_await facts_if_declared(context_.board, pattern("(learned ? ? ? ? ? ? ? ? ?)"));
  for (const Fact& fact : learned.value_or(std::vector<Fact>())) words_.emplace(fact.datum[2].text());
}

}  // namespace pizarra
