#include "agents/repl/repl.hpp"

#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra {

namespace {

// Events that were there before the prompt opened are history, not news.
Task<void> show_story(AgentContext& context, Terminal& terminal) {
  const Query events = query_for(read_one("(event ?n ?kind ?sentence ?detail)").value());
  const Result<std::unique_ptr<Watch>> watch = co_await context.board.watch(events);
  if (!watch) co_return;  // a board whose coordinator has yet to declare its story has none to show
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    if (change->resynchronised) continue;
    for (const Answer& answer : change->added) {
      const Datum& event = answer.facts.front().datum;
      terminal.print(fmt::format("  {:10} {}", event[2].text(), event[3].text()));
    }
  }
}

Task<void> evaluate_into(Interpreter& interpreter, std::string typed, Evaluation& outcome, Event& settled) {
  outcome = co_await interpreter.evaluate(std::move(typed));
  settled.set();
}

}  // namespace

Task<void> run_prompt(AgentContext& context, Interpreter& interpreter, Terminal& terminal) {
  terminal.words = [&interpreter]() -> const std::set<std::string>& { return interpreter.words(); };
  co_await interpreter.learn_words();
  Job story = context.executor.spawn(show_story(context, terminal));
  Event settled(context.executor);
  terminal.on_interrupt = [&settled] { settled.set(); };
  Evaluation outcome = Evaluation::done;
  while (outcome != Evaluation::quit) {
    std::optional<std::string> typed = co_await terminal.read();
    if (!typed) break;
    settled.reset();
    const Job evaluation = context.executor.spawn(evaluate_into(interpreter, std::move(*typed), outcome, settled));
    co_await settled.wait();
    if (!evaluation.done()) terminal.print("not waited for any longer; what an agent was asked to do goes on");
    if (story.done()) story = context.executor.spawn(show_story(context, terminal));
  }
  terminal.on_interrupt = nullptr;
}

Task<Evaluation> run_forms(Interpreter& interpreter, std::vector<std::string> forms) {
  for (const std::string& form : forms) {
    const Evaluation outcome = co_await interpreter.evaluate(form);
    if (outcome != Evaluation::done) co_return outcome;
  }
  co_return Evaluation::done;
}

}  // namespace pizarra
