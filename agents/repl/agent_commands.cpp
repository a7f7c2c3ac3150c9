#include "agents/repl/agent_commands.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "agents/repl/answer_text.hpp"
#include "agents/repl/eyes_commands.hpp"
#include "agents/repl/present_agents.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

constexpr Duration answer_timeout = 120s;

}  // namespace

Task<Evaluation> list_agents(Prompt& prompt, Typed) {
  const Result<std::vector<Fact>> present = co_await prompt.board.facts(read_pattern("(agent ? ? ?)"));
  if (!present) co_return prompt.show(present.error());
  for (const Fact& agent : *present) {
    prompt.print(fmt::format("  {} ({}) on {}", agent.datum[1].text(), agent.datum[2].text(), agent.datum[3].text()));
    const std::vector<Datum> offers = co_await offers_of(prompt.board, agent.datum[1]);
    for (const Datum& operation : offers) prompt.print("      " + write(operation));
  }
  co_return Evaluation::done;
}

Task<Evaluation> ask_agent(Prompt& prompt, std::string agent, Datum operation) {
  const Result<Datum> answer = co_await prompt.caller.call(agent, operation, answer_timeout);
  if (!answer) co_return prompt.show(answer.error(), Evaluation::failed);
  std::vector<Datum> remarks = co_await remarks_on(prompt.context, agent, operation, *answer);
  std::span<const Datum> values = answer->items();
  if (std::optional<Datum> reason = why_failed(*answer)) {
    values = values.first(1);
    remarks.push_back(*std::move(reason));
  }
  const bool sentences = std::ranges::all_of(values, &Datum::is_string);
  std::string line = answer->size() == 0 ? "ok" : "";
  for (const Datum& value : values) {
    line += (line.empty() ? "" : sentences ? "\n" : " ") + (sentences ? std::string(value.text()) : write(value));
  }
  for (const Datum& remark : remarks) line += "\n  " + std::string(remark.text());
  prompt.say(line, fmt::format("{{\"reply\":{}}}", json_values(answer->items())));
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
