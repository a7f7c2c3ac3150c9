#include "agents/repl/board_commands.hpp"

#include <fmt/format.h>

#include "agents/repl/answer_text.hpp"
#include "agents/repl/json_answers.hpp"

namespace pizarra::repl {

Task<Evaluation> ask_board(Prompt& prompt, Typed typed) {
  if (typed.form.size() != 2) co_return prompt.misused(typed);
  const Result<Query> query = query_from_datum(typed.form[1]);
  if (!query) co_return prompt.show(query.error(), Evaluation::malformed);
  const Result<Answers> answers = co_await prompt.board.ask(*query);
  if (!answers) co_return prompt.show(answers.error());
  std::string text = answers->answers.empty() ? "no" : "";
  for (const Answer& answer : answers->answers) text += (text.empty() ? "" : "\n") + bindings_text(answer);
  prompt.say(text,
             fmt::format("{{\"revision\":{},\"answers\":{}}}", answers->revision, json_answers(answers->answers)));
  co_return Evaluation::done;
}

Task<Evaluation> declare_relation(Prompt& prompt, Typed typed) {
  if (typed.form.size() != 2) co_return prompt.misused(typed);
  const Result<Relation> relation = relation_from_datum(typed.form[1]);
  if (!relation) co_return prompt.show(relation.error(), Evaluation::malformed);
  const std::vector<Relation> relations(1, *relation);
  const Result<void> declared = co_await prompt.board.declare(relations);
  if (!declared) co_return prompt.show(declared.error());
  prompt.say("declared " + relation->name, fmt::format("{{\"declared\":{}}}", json_string(relation->name)));
  co_return Evaluation::done;
}

Task<Evaluation> tell_fact(Prompt& prompt, Typed typed) {
  if (typed.form.size() != 2) co_return prompt.misused(typed);
  const Result<Revision> told = co_await prompt.board.tell(typed.form[1]);
  if (!told) co_return prompt.show(told.error());
  prompt.say(fmt::format("told, revision {}", *told), fmt::format("{{\"revision\":{}}}", *told));
  co_return Evaluation::done;
}

Task<Evaluation> retract_facts(Prompt& prompt, Typed typed) {
  if (typed.form.size() != 2) co_return prompt.misused(typed);
  const Result<std::vector<Fact>> fitting = co_await prompt.board.facts(typed.form[1]);
  if (!fitting) co_return prompt.show(fitting.error());
  const Result<Revision> retracted = co_await prompt.board.retract(typed.form[1]);
  if (!retracted) co_return prompt.show(retracted.error());
  prompt.say(fmt::format("retracted {}, revision {}", fitting->size(), *retracted),
             fmt::format("{{\"retracted\":{},\"revision\":{}}}", fitting->size(), *retracted));
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
