#include "agents/repl/watch_commands.hpp"

#include <fmt/format.h>

#include "agents/repl/answer_text.hpp"

namespace pizarra::repl {

Task<Evaluation> WatchCommands::watch(Typed typed) {
  if (typed.form.size() != 2) co_return prompt_.misused(typed);
  std::erase_if(watches_, [](const auto& entry) { return entry.second.done(); });
  if (watches_.size() >= max_watches) {
    const std::string sentence = fmt::format("{} watches run already; end one with (unwatch N)", max_watches);
    const Failure failure{"too-many", sentence, {}, {}};
    co_return prompt_.show(failure);
  }
  const Result<Query> query = query_from_datum(typed.form[1]);
  if (!query) co_return prompt_.show(query.error(), Evaluation::malformed);
  Result<std::unique_ptr<Watch>> watch = co_await prompt_.board.watch(*query);
  if (!watch) co_return prompt_.show(watch.error());
  const int number = next_watch_++;
  prompt_.say(fmt::format("watch {}", number), fmt::format("{{\"watch\":{}}}", number));
  watches_.emplace(number, prompt_.context.executor.spawn(follow(number, std::move(*watch))));
  co_return Evaluation::done;
}

Task<void> WatchCommands::follow(int number, std::unique_ptr<Watch> watch) {
  for (bool first = true;; first = false) {
    const Result<Change> change = co_await watch->next();
    if (!change) {
      prompt_.say(fmt::format("[{}] ended: {}", number, describe(change.error())),
                  fmt::format("{{\"watch\":{},\"error\":{}}}", number, json_failure(change.error())));
      co_return;
    }
    say_change(number, *change, first);
  }
}

void WatchCommands::say_change(int number, const Change& change, bool first) {
  std::string text;
  const auto add = [&](const std::string& line) {
    text += fmt::format("{}[{}] {}", text.empty() ? "" : "\n", number, line);
  };
  const bool missed = change.resynchronised && !first;
  if (missed) add("changes were missed: what was shown before is void, and this stands now");
  if (change.resynchronised && change.added.empty()) add(missed ? "nothing" : "nothing yet");
  for (const Answer& answer : change.removed) add("- " + bindings_text(answer));
  for (const Answer& answer : change.added) add("+ " + bindings_text(answer));
  prompt_.say(text, fmt::format("{{\"watch\":{},\"revision\":{},\"resynchronised\":{},\"removed\":{},\"added\":{}}}",
                                number, change.revision, change.resynchronised, json_answers(change.removed),
                                json_answers(change.added)));
}

Task<Evaluation> WatchCommands::unwatch(Typed typed) {
  const bool shaped = typed.form.size() == 2 && typed.form[1].is_integer();
  if (!shaped) co_return prompt_.misused(typed);
  if (watches_.erase(static_cast<int>(typed.form[1].integer())) == 0) {
    prompt_.print(fmt::format("there is no watch {}", typed.form[1].integer()));
    co_return Evaluation::failed;
  }
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
