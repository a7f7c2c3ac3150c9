#include "agents/scheme/running_program.hpp"

#include <algorithm>

#include "agents/runtime/declared.hpp"

namespace pizarra::scheme {

namespace {

std::vector<FactId> ids_of(const Answer& answer) {
  std::vector<FactId> ids;
  for (const Fact& fact : answer.facts) ids.push_back(fact.id);
  return ids;
}

Datum bindings_of(const Answer& answer, const std::vector<std::string>& variables) {
  std::vector<Datum> bindings;
  for (const std::string& variable : variables) {
    const Datum* value = answer.bindings.find(variable);
    bindings.push_back(list(Datum::symbol(variable), value != nullptr ? *value : Datum()));
  }
  return Datum::list(std::move(bindings));
}

const forms::ProgramPart& operation_called(const forms::AgentProgram& program, std::string_view name) {
  return *std::ranges::find(program.parts(), name, &forms::ProgramPart::name);
}

// Anybody may declare a relation, also who is no agent and is not seen to come: it is looked at again and again.
constexpr Duration declared_pause = 300ms;

Task<void> until_declared(runtime::AgentContext& context, const Query& condition) {
  for (const Query::Clause& clause : condition.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    while (true) {
      const Result<bool> declared = co_await runtime::is_declared(context.board, std::string(clause.form.head()));
      if (declared && *declared) break;
      co_await sleep(context.executor, declared_pause);
    }
  }
}

}  // namespace

RunningProgram::RunningProgram(runtime::AgentContext& context, std::shared_ptr<PartRunner> runner)
    : context_(context), runner_(std::move(runner)) {
  if (runner_->program() == nullptr) return;
  for (const forms::ProgramPart& part : runner_->program()->parts()) {
    using enum forms::ProgramPart::Sort;
    if (part.sort == rule || part.sort == conclusion) jobs_.push_back(context_.executor.spawn(follow_rule(part)));
    if (part.sort == loop) jobs_.push_back(context_.executor.spawn(go_round(part)));
  }
}

Task<void> RunningProgram::follow_rule(const forms::ProgramPart& rule) {
  const Query condition = query_from_datum(rule.head).value();
  Fired fired;
  while (true) {
    co_await until_declared(context_, condition);
    const Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(condition);
    if (watch) {
      const Result<void> ended = co_await follow_watch(rule, **watch, fired);
      // The board is away, or refuses, or does not know what is concluded: asked again until it does.
    }
    co_await sleep(context_.executor, retry_pause);
  }
}

Task<Result<void>> RunningProgram::follow_watch(const forms::ProgramPart& rule, Watch& watch, Fired& fired) {
  while (true) {
    const Result<Change> change = co_await watch.next();
    if (!change) co_return fail(change);
    std::optional<Failure> undeclared;
    for (const Answer& answer : change->added) {
      const bool known = fired.contains(ids_of(answer));
      if (known) continue;
      // What went wrong with it was told.
      const Result<void> done = co_await fire(rule, answer, fired);
      const bool again = !done && rule.sort == forms::ProgramPart::Sort::conclusion;
      if (!again || done.error().symbol != "undeclared-relation") continue;
      fired.erase(ids_of(answer));
      undeclared = done.error();
    }
    const Result<void> forgotten = co_await forget_gone(*change, fired);
    // The next watch begins with all that holds, and so with what is not concluded yet.
    if (undeclared) co_return fail(*undeclared);
  }
}

Task<Result<void>> RunningProgram::fire(const forms::ProgramPart& rule, Answer answer, Fired& fired) {
  std::vector<FactId> because = ids_of(answer);
  std::vector<Datum>& holds = fired[because];
  const FactId shown = runner_->rule_fact(rule.name);
  if (shown != 0) because.push_back(shown);
  Datum bindings = bindings_of(answer, rule.variables);
  const Result<Performed> performed =
      co_await PartRunner::perform(runner_, rule.name, std::move(bindings), std::move(because));
  if (!performed) co_return fail(performed);
  if (rule.sort != forms::ProgramPart::Sort::conclusion) co_return {};
  holds = performed->told;
  runner_->hold(holds);
  co_await runner_->take_back_fault(rule.name);
  co_return {};
}

Task<Result<void>> RunningProgram::forget_gone(const Change& change, Fired& fired) {
  std::vector<std::vector<FactId>> gone;
  for (const Answer& answer : change.removed) gone.push_back(ids_of(answer));
  if (change.resynchronised) {
    std::set<std::vector<FactId>> there;
    for (const Answer& answer : change.added) there.insert(ids_of(answer));
    for (const auto& [ids, holds] : fired) {
      if (!there.contains(ids)) gone.push_back(ids);
    }
  }
  std::vector<Datum> facts;
  for (const std::vector<FactId>& ids : gone) {
    const auto found = fired.find(ids);
    if (found == fired.end()) continue;
    facts.insert(facts.end(), found->second.begin(), found->second.end());
    fired.erase(found);
  }
  co_return co_await runner_->let_go(std::move(facts));
}

Task<void> RunningProgram::go_round(const forms::ProgramPart& loop) {
  while (true) {
    co_await sleep(context_.executor, loop.period);
    const Datum none;
    // What went wrong with it was told.
    const Result<Performed> performed = co_await PartRunner::perform(runner_, loop.name, none, std::vector<FactId>());
    if (!performed && performed.error().symbol == "off") co_return;
  }
}

Task<Result<Datum>> RunningProgram::answer(std::shared_ptr<PartRunner> runner, Datum operation) {
  const forms::ProgramPart& offered = operation_called(*runner->program(), operation.head());
  std::vector<Datum> bindings;
  for (std::size_t i = 1; i < operation.size(); ++i) {
    bindings.push_back(list(offered.head[i][0], operation[i]));
  }
  Datum arguments = Datum::list(std::move(bindings));
  const Result<Performed> performed =
      co_await PartRunner::perform(runner, offered.name, std::move(arguments), std::vector<FactId>());
  if (!performed) co_return fail(performed);
  if (performed->value.is_list()) co_return performed->value;
  co_return list(performed->value);
}

}  // namespace pizarra::scheme
