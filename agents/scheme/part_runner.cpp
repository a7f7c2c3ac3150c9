#include "agents/scheme/part_runner.hpp"

#include <fmt/format.h>

#include "blackboard/away.hpp"
#include "lisp/writer.hpp"

namespace pizarra::scheme {

namespace {

// A run that waits for the board, forgotten unless it is gone on with.
class Suspended {
 public:
  Suspended(std::shared_ptr<const forms::AgentProgram> program, std::int64_t waiting)
      : program_(std::move(program)), waiting_(waiting) {}
  Suspended(const Suspended&) = delete;
  Suspended& operator=(const Suspended&) = delete;
  ~Suspended() {
    if (waiting_ != 0) program_->abandon(waiting_);
  }
  forms::ProgramOutcome resume(Datum answer, std::int64_t now_ms) {
    return program_->resume(std::exchange(waiting_, 0), std::move(answer), now_ms);
  }

 private:
  std::shared_ptr<const forms::AgentProgram> program_;
  std::int64_t waiting_;
};

bool breaks_a_limit(const Failure& failure) {
  return failure.symbol == "too-slow" || failure.symbol == "too-much-memory" || failure.symbol == "too-many";
}

bool is_operation(const forms::AgentProgram& program, const std::string& name) {
  for (const forms::ProgramPart& part : program.parts()) {
    if (part.name == name) return part.sort == forms::ProgramPart::Sort::operation;
  }
  return false;
}

std::vector<Datum> facts_told(const forms::ProgramEffects& effects) {
  std::vector<Datum> facts;
  for (const Datum& step : effects.steps) {
    if (step.is_form("tell")) facts.push_back(step[1]);
  }
  return facts;
}

}  // namespace

PartRunner::PartRunner(runtime::AgentContext& context, runtime::Caller& caller,
                       std::shared_ptr<const forms::AgentProgram> program, LeaseId lease, Allowance& allowance, Log log)
    : context_(context),
      caller_(caller),
      program_(std::move(program)),
      lease_(lease),
      allowance_(allowance),
      log_(std::move(log)) {
  if (!program_) return;
  for (const Datum& posted : program_->posts()) {
    const Result<Relation> relation = relation_from_datum(posted);
    if (relation && relation->durable) durable_.insert(relation->name);
  }
}

std::int64_t PartRunner::now_ms() const {
  return std::chrono::duration_cast<std::chrono::milliseconds>(context_.executor.now().time_since_epoch()).count();
}

LeaseId PartRunner::lease_of(const Datum& fact) const { return durable_.contains(fact.head()) ? 0 : lease_; }

FactId PartRunner::rule_fact(const std::string& rule) const {
  const auto found = rule_facts_.find(rule);
  return found == rule_facts_.end() ? 0 : found->second;
}

// A board that is away comes back.
Task<Result<Revision>> PartRunner::commit(Transaction transaction) {
  const Duration wait = allowance_.take(transaction.steps.size(), context_.executor.now());
  if (wait > Duration(0)) co_await sleep(context_.executor, wait);
  while (true) {
    Transaction again = transaction;
    const Result<Revision> told = co_await context_.board.transact(std::move(again));
    const Result<Revision> stands = if_it_stands(told);
    if (stands || !is_away(stands.error())) co_return stands;
    co_await sleep(context_.executor, retry_pause);
  }
}

Task<Result<void>> PartRunner::carry_out(forms::ProgramEffects effects, std::vector<FactId> because) {
  for (const std::string& line : effects.said) log_(line);
  if (effects.steps.empty()) co_return {};
  Transaction transaction;
  for (const Datum& step : effects.steps) {
    if (step.is_form("tell")) {
      transaction.tell(step[1], because, lease_of(step[1]));
    } else {
      transaction.retract(step[1]);
    }
  }
  const Result<Revision> told = co_await commit(std::move(transaction));
  if (!told) co_return fail(told);
  co_return {};
}

Task<Result<Datum>> PartRunner::find_answers(Datum question) {
  Result<Query> query = query_from_datum(question[1]);
  if (!query) co_return fail(query);
  const Result<Answers> found = co_await context_.board.ask(std::move(*query));
  if (!found) co_return fail(found);
  std::vector<Datum> answers;
  for (const Answer& answer : found->answers) {
    std::vector<Datum> values;
    for (const Datum& variable : question[2].items()) {
      const Datum* value = answer.bindings.find(variable);
      values.push_back(value != nullptr ? *value : Datum());
    }
    answers.push_back(Datum::list(std::move(values)));
  }
  co_return Datum::list(std::move(answers));
}

Task<Result<Datum>> PartRunner::ask_agent(Datum question) {
  const bool named = question[1].is_symbol();
  if (!named) co_return fail("bad-call", "the agent that is called is a symbol", question[1]);
  const std::string agent(question[1].text());
  const Datum& operation = question[2];
  const Duration patience = std::chrono::milliseconds(question[3].integer());
  co_return co_await caller_.call(agent, operation, patience);
}

Task<Datum> PartRunner::answer_to(Datum question) {
  const Duration wait = allowance_.take(1, context_.executor.now());
  if (wait > Duration(0)) co_await sleep(context_.executor, wait);
  Result<Datum> answer = Datum();
  if (question.is_form("ask")) {
    answer = co_await find_answers(question);
  } else if (question.is_form("call")) {
    answer = co_await ask_agent(question);
  } else {
    co_await sleep(context_.executor, std::chrono::milliseconds(question[1].integer()));
  }
  if (answer) co_return list("ok"_sym, *answer);
  co_return list("fail"_sym, Datum::symbol(answer.error().symbol), answer.error().sentence);
}

Task<Result<Performed>> PartRunner::carry_through(std::shared_ptr<PartRunner> runner, std::string part, Datum bindings,
                                                  std::vector<FactId> because) {
  Performed performed;
  forms::ProgramOutcome outcome = runner->program_->run(part, std::move(bindings), runner->now_ms());
  while (outcome.effects) {
    Suspended suspended(runner->program_, outcome.waiting);
    for (Datum& fact : facts_told(*outcome.effects)) performed.told.push_back(std::move(fact));
    const Result<void> carried_out = co_await runner->carry_out(*outcome.effects, because);
    if (!carried_out) co_return fail(carried_out);
    if (!outcome.question) {
      performed.value = outcome.value;
      co_return performed;
    }
    const Datum question = *outcome.question;
    Datum answer = co_await runner->answer_to(question);
    outcome = suspended.resume(std::move(answer), runner->now_ms());
  }
  co_return fail(outcome.effects);
}

Task<void> PartRunner::tell_fault(std::string part, Failure failure) {
  std::string text = failure.sentence;
  if (off_.contains(part)) text += "; it is off until the file is saved again";
  // It stands on the board, and in the log; who fails again and again in the same way fills neither.
  std::string& told_before = faults_[part];
  if (std::exchange(told_before, text) == text) co_return;
  log_(fmt::format("{}: {}", part, text));
  Transaction fault;
  fault.tell(list("program-fault"_sym, Datum::symbol(context_.name), Datum::symbol(part), text), {}, lease_);
  // Of a board that does not take it, the log speaks alone.
  [[maybe_unused]] const Result<Revision> told = co_await commit(std::move(fault));
}

Task<void> PartRunner::take_back_fault(std::string part) {
  if (faults_.erase(part) == 0) co_return;
  Transaction well;
  well.retract(list("program-fault"_sym, Datum::symbol(context_.name), Datum::symbol(part), "?"_sym));
  [[maybe_unused]] const Result<Revision> told = co_await commit(std::move(well));
}

Task<Result<Performed>> PartRunner::perform(std::shared_ptr<PartRunner> runner, std::string part, Datum bindings,
                                            std::vector<FactId> because) {
  if (runner->off_.contains(part)) {
    co_return fail("off", fmt::format("{} broke a limit and is off until the file is saved again", part));
  }
  Result<Performed> performed = co_await carry_through(runner, part, std::move(bindings), std::move(because));
  if (performed) co_return performed;
  const Failure& failure = performed.error();
  if (breaks_a_limit(failure)) runner->off_.insert(part);
  if (failure.symbol == "too-much-kept") runner->broken_ = failure;
  const bool answered = is_operation(*runner->program_, part) && !breaks_a_limit(failure);
  if (!answered) co_await runner->tell_fault(part, failure);
  co_return performed;
}

Task<Result<void>> PartRunner::introduce() {
  if (!program_) co_return {};
  const Datum agent = Datum::symbol(context_.name);
  Transaction rules;
  for (const forms::ProgramPart& part : program_->parts()) {
    using enum forms::ProgramPart::Sort;
    if (part.sort != rule && part.sort != conclusion) continue;
    rules.tell(list("rule"_sym, agent, Datum::symbol(part.name), write(part.head)), {}, lease_);
  }
  const bool any = !rules.steps.empty();
  if (any) {
    const Result<Revision> told = co_await commit(std::move(rules));
    if (!told) co_return fail(told);
    const Result<std::vector<Fact>> facts = co_await context_.board.facts(list("rule"_sym, agent, "?"_sym, "?"_sym));
    // An agent that may not read them tells its facts without naming the rule.
    if (facts) {
      for (const Fact& fact : *facts) rule_facts_[std::string(fact.datum[2].text())] = fact.id;
    }
  }
  std::vector<FactId> no_reason;
  co_return co_await carry_out(program_->effects(), std::move(no_reason));
}

void PartRunner::hold(const std::vector<Datum>& facts) {
  for (const Datum& fact : facts) ++held_[fact];
}

Task<Result<void>> PartRunner::let_go(std::vector<Datum> facts) {
  Transaction transaction;
  for (Datum& fact : facts) {
    const auto held = held_.find(fact);
    if (held == held_.end() || --held->second > 0) continue;
    held_.erase(held);
    transaction.retract(std::move(fact));
  }
  if (transaction.steps.empty()) co_return {};
  const Result<Revision> gone = co_await commit(std::move(transaction));
  if (!gone) co_return fail(gone);
  co_return {};
}

}  // namespace pizarra::scheme
