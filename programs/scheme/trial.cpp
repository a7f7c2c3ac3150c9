#include "programs/scheme/trial.hpp"

#include <fmt/format.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/writer.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration patience = 1s;
constexpr Duration step = 100ms;  // what each form gives the agent to answer

class Trial {
 public:
  Trial(const std::string& name, scheme::SchemeOptions options)
      : name_(name), board_(executor_), view_(board_.view(name)), teller_(board_.view("story")) {
    options.log = [this, log = options.log](const std::string& line) {
      if (log) log(line);
    };
    agent_.emplace(runtime::AgentContext{name, "localhost", executor_, *view_, Random(1)}, std::move(options));
    job_ = executor_.spawn(live());
    executor_.run_for(step);
  }

  // Answers what was not as expected, or nothing. Fails where the form is none of these.
  Result<std::string> perform(const Datum& form);
  Result<std::string> loaded();

 private:
  Task<void> live() { ended_ = co_await agent_->run(); }

  template <class T>
  Result<T> wait_for(Task<Result<T>> task) {
    std::optional<Result<T>> result;
    const Job job = executor_.spawn([](Task<Result<T>> asked, std::optional<Result<T>>& told) -> Task<void> {
      told = co_await asked;
    }(std::move(task), result));
    executor_.run_until([&] { return result.has_value(); });
    return std::move(*result);
  }
  Result<std::string> tell(const Datum& form);
  Result<std::string> expect(const Datum& form, bool there);
  Result<std::string> call(const Datum& form);

  std::string name_;
  VirtualExecutor executor_;
  memory::MemoryBoard board_;
  std::unique_ptr<Board> view_;
  std::unique_ptr<Board> teller_;
  std::optional<scheme::SchemeAgent> agent_;
  std::optional<Result<void>> ended_;
  int calls_ = 0;
  Job job_;
};

Result<std::string> Trial::loaded() {
  const Result<Answers> state =
      wait_for(teller_->ask(query_for(list("program"_sym, Datum::symbol(name_), "?state"_sym, "?why"_sym))));
  if (!state) return fail(state);
  if (state->answers.empty()) return fail("bad-program", "the agent has not come to the board");
  const Bindings& said = state->answers.front().bindings;
  if (said.find("?state")->is_symbol("runs")) return std::string();
  return fail("bad-program", std::string(said.find("?why")->text()));
}

Result<std::string> Trial::tell(const Datum& form) {
  Transaction transaction;
  for (const Datum& item : form.items().subspan(1)) {
    if (form.is_form("tell")) {
      transaction.tell(item);
    } else {
      transaction.retract(item);
    }
  }
  const Result<Revision> told = wait_for(teller_->transact(std::move(transaction)));
  if (!told) return fail(told);
  executor_.run_for(step);
  return std::string();
}

Result<std::string> Trial::expect(const Datum& form, bool there) {
  const Time deadline = executor_.now() + patience;
  for (const Datum& item : form.items().subspan(1)) {
    while (true) {
      const Result<Query> query = query_from_datum(item);
      if (!query) return fail(query);
      const Result<Answers> found = wait_for(teller_->ask(*query));
      if (!found) return fail(found);
      if (!there && !found->answers.empty()) return fmt::format("{} holds", write(item));
      if (!there || !found->answers.empty()) break;
      if (executor_.now() >= deadline) return fmt::format("{} does not hold", write(item));
      executor_.run_for(step);
    }
  }
  return std::string();
}

Result<std::string> Trial::call(const Datum& form) {
  if (form.size() != 3) return fail("malformed", "a call is (call OPERATION ANSWERS) or (call OPERATION fails)");
  const Datum id = Datum::symbol(fmt::format("story-{}", ++calls_));
  const Result<Revision> asked = wait_for(teller_->tell(list("request"_sym, id, Datum::symbol(name_), form[1])));
  if (!asked) return fail(asked);
  const Query replied = query_for(list("reply"_sym, id, "?answer"_sym));
  const Result<Answer> answer = wait_for(await_answer(*teller_, replied, executor_.now() + 60 * patience, executor_));
  if (!answer) return fmt::format("{} is not answered", write(form[1]));
  const Datum result = *answer->bindings.find("?answer");
  if (form[2].is_symbol("fails")) {
    return result.is_form("fail") ? std::string() : fmt::format("{} answers {}", write(form[1]), write(result));
  }
  std::vector<Datum> wanted{"ok"_sym};
  wanted.insert(wanted.end(), form[2].items().begin(), form[2].items().end());
  if (result == Datum::list(wanted)) return std::string();
  return fmt::format("{} answers {} in place of {}", write(form[1]), write(result), write(Datum::list(wanted)));
}

Result<std::string> Trial::perform(const Datum& form) {
  if (form.is_form("tell") || form.is_form("retract")) return tell(form);
  if (form.is_form("expect")) return expect(form, true);
  if (form.is_form("absent")) return expect(form, false);
  if (form.is_form("call")) return call(form);
  if (form.is_form("wait") && form.size() == 2 && form[1].is_integer() && form[1].integer() >= 0) {
    executor_.run_for(std::chrono::milliseconds(std::min<std::int64_t>(form[1].integer(), 3'600'000)));
    return std::string();
  }
  if (!form.is_form("declare")) {
    return fail("malformed",
                "a step is (declare RELATION ...), (tell FACT ...), (retract PATTERN ...), (expect QUERY "
                "...), (absent QUERY ...), (call OPERATION ANSWERS) or (wait MS)");
  }
  std::vector<Relation> relations;
  for (const Datum& item : form.items().subspan(1)) {
    Result<Relation> relation = relation_from_datum(item);
    if (!relation) return fail(relation);
    relations.push_back(std::move(*relation));
  }
  const Result<void> declared = wait_for(teller_->declare(std::move(relations)));
  if (!declared) return fail(declared);
  executor_.run_for(patience);
  return std::string();
}

}  // namespace

Result<std::vector<std::string>> try_agent(const std::string& name, scheme::SchemeOptions options,
                                           const Source& story) {
  Trial trial(name, std::move(options));
  const Result<std::string> loaded = trial.loaded();
  if (!loaded) return fail(loaded);
  std::vector<std::string> wrong;
  for (std::size_t i = 0; i < story.data().size(); ++i) {
    const Result<std::string> done = trial.perform(story.data()[i]);
    if (!done) return fail(story.failure_at({i}, done.error().symbol, done.error().sentence));
    if (!done->empty()) wrong.push_back(describe(story.failure_at({i}, "not-as-expected", *done)));
  }
  return wrong;
}

}  // namespace pizarra::programs
