#include "agents/repl/commands.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/repl/agent_commands.hpp"
#include "agents/repl/answer_text.hpp"
#include "agents/repl/eyes_commands.hpp"
#include "agents/repl/present_agents.hpp"
#include "agents/repl/prompt.hpp"
#include "agents/repl/role_commands.hpp"
#include "lisp/nearest.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

// The commands about the facts of the board, whatever they mean: ask, declare, tell, retract.
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

Task<Evaluation> quit(Typed) { co_return Evaluation::quit; }

}  // namespace

Commands::Commands(Prompt& prompt, const runtime::Service& service, Patience patience)
    : prompt_(prompt), goals_(prompt, patience), names_(prompt, service), watches_(prompt), all_(table()) {}

std::vector<Command> Commands::table() {
  const auto plain = [this](auto run) { return std::bind_front(run, std::ref(prompt_)); };
  const auto goals = [this](auto run) { return std::bind_front(run, &goals_); };
  const auto names = [this](auto run) { return std::bind_front(run, &names_); };
  const auto watches = [this](auto run) { return std::bind_front(run, &watches_); };
  return {
      {"goal", "(goal FACT ...)", "build it: (goal (on circle triangle) (on triangle square))",
       goals(&GoalCommands::goal)},
      {"cancel", "(cancel)", "give the goal up", goals(&GoalCommands::cancel)},
      {"plan", "(plan)", "the plan in use and the operation in hand", goals(&GoalCommands::plan)},
      {"why", "(why) (why PATTERN) (why not GOAL ...)",
       "why the plan is what it is: which sighting broke which expectation; why facts that fit stand; why a goal does "
       "not hold, and what would bring it about",
       goals(&GoalCommands::why)},
      {"objects", "(objects)", "the learned objects and where they are seen", plain(list_objects)},
      {"agents", "(agents)", "the agents that are present and what they offer", plain(list_agents)},
      {"find", "(find KIND CONDITION ...)", "the agents of a kind, by properties: (find robot (reach > 600) (host ?))",
       names(&NameCommands::find)},
      {"bind", "(bind PATH AGENT)",
       "name an agent in the tree of contexts: (bind (cell arms left) robot); the name goes with this prompt",
       names(&NameCommands::bind)},
      {"rebind", "(rebind PATH AGENT)", "the same, in place of whoever has the name", names(&NameCommands::bind)},
      {"unbind", "(unbind PATH)", "take a name away; an agent binds its own name again", names(&NameCommands::unbind)},
      {"resolve", "(resolve PATH)", "who has a name: (resolve (cell arms robot))", names(&NameCommands::resolve)},
      {"list", "(list PATH)", "the names and contexts in a context: (list (cell arms)); (list) those above all",
       names(&NameCommands::list_names)},
      {"wire", "(wire CLIENT ROLE AGENT)",
       "have another agent serve: (wire coordinator eyes vision-2); without AGENT the usual one, (wire) lists who "
       "serves",
       plain(wire)},
      {"ask", "(ask QUERY)", "the facts that hold now: (ask (on ?x ?y)), (ask (and (clear ?x) (not (on ?x ?y))))",
       plain(ask_board)},
      {"watch", "(watch QUERY)", "the facts that hold now, then every change", watches(&WatchCommands::watch)},
      {"unwatch", "(unwatch N)", "end watch N", watches(&WatchCommands::unwatch)},
      {"declare", "(declare RELATION)",
       "say what facts are called and hold: (declare (relation seen ((name symbol) (x number)) (key name)))",
       plain(declare_relation)},
      {"tell", "(tell FACT)", "put a fact on the board: (tell (stop me \"wait\")) stops the arm", plain(tell_fact)},
      {"retract", "(retract PATTERN)",
       "take every fact that fits off the board: (retract (stop me ?)) lets the arm move again", plain(retract_facts)},
      {"help", "(help) (help COMMAND)", "this list, or one line of it; (help AGENT): what that agent offers",
       std::bind_front(&Commands::help, this)},
      {"quit", "(quit)", "leave; Ctrl-D or Ctrl-C on an empty line do the same, Ctrl-C after text drops it", quit},
  };
}

const Command* Commands::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Command::name);
  return found == all_.end() ? nullptr : &*found;
}

Task<Failure> Commands::unknown(Datum form) {
  constexpr std::size_t shown = 40;
  std::vector<std::string> known;
  for (const Command& command : all_) known.emplace_back(command.name);
  const Result<std::vector<Fact>> present = co_await prompt_.board.facts(list("agent"_sym, "?"_sym, "?"_sym, "?"_sym));
  for (const Fact& agent : present.value_or(std::vector<Fact>())) known.emplace_back(agent.datum[1].text());
  std::string name(form.head().substr(0, shown));
  if (form.head().size() > shown) name += "...";
  const std::string near = nearest_name(form.head(), known);
  std::string sentence =
      name.empty() ? "a command is a form that begins with its name" : "there is no command or agent " + name;
  sentence += near.empty() ? "; (help) lists them" : fmt::format("; did you mean {}?", near);
  co_return Failure{"unknown-command", sentence, name.empty() ? Datum() : Datum::symbol(name), {}};
}

Task<Evaluation> Commands::help(Typed typed) {
  if (typed.form.size() > 2) co_return prompt_.misused(typed);
  if (typed.form.size() == 2) co_return co_await help_with(typed.form[1]);
  for (const Command& command : all_) prompt_.print(fmt::format("  {:22} {}", command.usage, command.help));
  prompt_.print("  (AGENT (OPERATION ...)) ask one agent: (robot (monitor)), (vision (get-objects));");
  prompt_.print("                         (robot (get-control)) resets an arm's alarm and switches its servos on");
  co_return Evaluation::done;
}

Task<Evaluation> Commands::help_with(Datum word) {
  const std::string name(word.is_symbol() ? word.text() : "");
  if (const Command* command = find(name)) {
    prompt_.print(fmt::format("  {:22} {}", command->usage, command->help));
    co_return Evaluation::done;
  }
  const bool present = co_await is_present(prompt_.board, name);
  if (!present) {
    const Failure neither = co_await unknown(as_form(word));
    co_return prompt_.show(neither, Evaluation::malformed);
  }
  const std::vector<Datum> offers = co_await offers_of(prompt_.board, word);
  for (const Datum& operation : offers) prompt_.print(fmt::format("  ({} {})", name, write(operation)));
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
