#include "agents/repl/interpreter.hpp"

#include <fmt/format.h>

#include "agents/repl/agent_commands.hpp"
#include "agents/repl/present_agents.hpp"

namespace pizarra::repl {

Interpreter::Interpreter(runtime::AgentContext& context, const runtime::Service& service, Output output,
                         Patience patience, Style style)
    : prompt_(context, service, std::move(output), style), commands_(prompt_, service, patience) {
  for (const Command& command : commands()) words_.emplace(command.name);
}

Task<Evaluation> Interpreter::evaluate(std::string text) {
  const ReadLimits limits{.bytes = 64 << 10, .depth = 64, .elements = 10'000};
  const Result<Source> source = read_source(text, "input", limits);
  if (!source) co_return prompt_.show(source.error(), Evaluation::malformed);
  for (std::size_t i = 0; i < source->data().size(); ++i) {
    const Datum form = as_form(source->data()[i]);
    bool known = commands_.find(form.head()) != nullptr;
    if (!known) known = co_await is_present(prompt_.board, std::string(form.head()));
    if (!known) {
      Failure unknown = co_await commands_.unknown(form);
      unknown.place = source->failure_at({i}, {}, {}).place;
      co_return prompt_.show(unknown, Evaluation::malformed);
    }
    const Evaluation outcome = co_await evaluate_form(form);
    if (outcome != Evaluation::done) co_return outcome;
  }
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::evaluate_form(Datum form) {
  if (const Command* command = commands_.find(form.head())) {
    Typed typed{form, command->usage};
    co_return co_await command->run(std::move(typed));
  }
  if (form.size() != 2) {
    const std::string sentence =
        fmt::format("an agent is asked as ({} (OPERATION ARGUMENT ...)); (agents) lists what they offer", form.head());
    const Failure failure{"malformed", sentence, {}, {}};
    co_return prompt_.show(failure, Evaluation::malformed);
  }
  const Datum operation = as_form(form[1]);
  co_return co_await ask_agent(prompt_, std::string(form.head()), operation);
}

// What cannot be learned now keeps its old names.
Task<void> Interpreter::learn_words() {
  std::set<std::string> words = co_await names_on(prompt_.board);
  if (words.empty()) co_return;
  for (const Command& command : commands()) words.emplace(command.name);
  words_ = std::move(words);
}

}  // namespace pizarra::repl
