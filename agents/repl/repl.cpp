#include "agents/repl/repl.hpp"

#include <fmt/format.h>

#include "agents/runtime/declared.hpp"
#include "lisp/reader.hpp"

namespace pizarra::repl {

namespace {

// Shows what comes to hold of a query; what held before the prompt opened is history, not news.
Task<void> show_news(runtime::AgentContext& context, Terminal& terminal, Query query,
                     std::string (*line)(const Datum&)) {
  Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(context.board, query);
  while (!watch) {
    co_await sleep(context.executor, retry_pause);
    watch = co_await runtime::watch_when_declared(context.board, query);
  }
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    if (change->resynchronised) continue;
    for (const Answer& answer : change->added) terminal.print(line(answer.facts.front().datum));
  }
}

std::string event_line(const Datum& event) { return fmt::format("  {:10} {}", event[2].text(), event[3].text()); }

std::string teaching_line(const Datum& person) {
  if (person[1].is_symbol("teaching")) return fmt::format("  {:10} {}", "learning", person[2].text());
  if (person[1].is_symbol("done"))
    return fmt::format("  {:10} {} objects: a goal may come", "learned", person[2].size());
  return fmt::format("  {:10} {}", "failure", describe(failure_from_datum(person[2])));
}

Task<void> evaluate_into(Interpreter& interpreter, std::string typed, Evaluation& outcome, Event& settled) {
  outcome = co_await interpreter.evaluate(std::move(typed));
  // Only who types completes names.
  co_await interpreter.learn_words();
  settled.set();
}

}  // namespace

Task<Evaluation> run_prompt(runtime::AgentContext& context, Interpreter& interpreter, Terminal& terminal) {
  terminal.words = [&interpreter]() -> const std::set<std::string>& { return interpreter.words(); };
  co_await interpreter.learn_words();
  const auto news_of = [&](const char* pattern, std::string (*line)(const Datum&)) {
    return context.executor.spawn(show_news(context, terminal, query_for(read_one(pattern).value()), line));
  };
  const Job story = news_of("(event ?n ?kind ?sentence ?detail)", event_line);
  const Job teaching = news_of("(person ?state ?detail)", teaching_line);
  Event settled(context.executor);
  terminal.on_interrupt = [&settled] { settled.set(); };
  Evaluation outcome = Evaluation::done;
  Evaluation first_failure = Evaluation::done;
  while (outcome != Evaluation::quit) {
    std::optional<std::string> typed = co_await terminal.read();
    if (!typed) break;
    settled.reset();
    const Job evaluation = context.executor.spawn(evaluate_into(interpreter, std::move(*typed), outcome, settled));
    co_await settled.wait();
    if (!evaluation.done()) terminal.print("not waited for any longer; requests to agents go on");
    const bool well = outcome == Evaluation::done || outcome == Evaluation::quit;
    if (!well && first_failure == Evaluation::done) first_failure = outcome;
  }
  terminal.on_interrupt = nullptr;
  co_return first_failure;
}

Task<Evaluation> run_forms(Interpreter& interpreter, std::vector<std::string> forms) {
  for (const std::string& form : forms) {
    const Evaluation outcome = co_await interpreter.evaluate(form);
    if (outcome != Evaluation::done) co_return outcome;
  }
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
