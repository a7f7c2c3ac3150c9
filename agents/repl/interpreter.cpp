#include "agents/repl/interpreter.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/repl/answer_text.hpp"
#include "agents/repl/commands.hpp"
#include "agents/repl/json_answers.hpp"
#include "blackboard/away.hpp"
#include "lisp/nearest.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

constexpr Duration answer_timeout = 120s;

const Command* find_command(std::string_view name) {
  const auto commands = Command::all();
  const auto found = std::ranges::find(commands, name, &Command::name);
  return found == commands.end() ? nullptr : &*found;
}

// A person who leaves the parentheses of a lone command away is understood.
Datum as_form(const Datum& typed) { return typed.is_symbol() ? list(typed) : typed; }

}  // namespace

Interpreter::Interpreter(runtime::AgentContext& context, const runtime::Service& service, Output output,
                         Patience patience, Style style)
    : context_(context),
      caller_(context, service),
      naming_(context, service),
      output_(std::move(output)),
      patience_(patience),
      style_(style) {
  for (const Command& command : Command::all()) words_.emplace(command.name);
}

void Interpreter::say(const std::string& text, const std::string& json) {
  output_(style_ == Style::json ? json : text);
}

Evaluation Interpreter::show(const Failure& failure, Evaluation outcome) {
  say(describe(failure), json_error(failure));
  return outcome;
}

Evaluation Interpreter::show(const Failure& failure) {
  return show(failure, is_away(failure) ? Evaluation::unavailable : Evaluation::failed);
}

Evaluation Interpreter::usage(std::string_view command) {
  const std::string sentence = fmt::format("{0} is {1}; (help {0}) says more", command, find_command(command)->usage);
  return show({"malformed", sentence, {}, {}}, Evaluation::malformed);
}

Task<Evaluation> Interpreter::evaluate(std::string text) {
  const ReadLimits limits{.bytes = 64 << 10, .depth = 64, .elements = 10'000};
  const Result<Source> source = read_source(text, "input", limits);
  if (!source) co_return show(source.error(), Evaluation::malformed);
  for (std::size_t i = 0; i < source->data().size(); ++i) {
    const Datum form = as_form(source->data()[i]);
    const bool known = co_await is_agent(std::string(form.head()));
    if (find_command(form.head()) == nullptr && !known) {
      Failure unknown = co_await unknown_command(form);
      unknown.place = source->failure_at({i}, {}, {}).place;
      co_return show(unknown, Evaluation::malformed);
    }
    const Evaluation outcome = co_await evaluate_form(form);
    if (outcome != Evaluation::done) co_return outcome;
  }
  co_return Evaluation::done;
}

Task<Failure> Interpreter::unknown_command(Datum form) {
  constexpr std::size_t shown = 40;
  std::vector<std::string> known;
  for (const Command& command : Command::all()) known.emplace_back(command.name);
  const Result<std::vector<Fact>> present = co_await context_.board.facts(list("agent"_sym, "?"_sym, "?"_sym, "?"_sym));
  for (const Fact& agent : present.value_or(std::vector<Fact>())) known.emplace_back(agent.datum[1].text());
  std::string name(form.head().substr(0, shown));
  if (form.head().size() > shown) name += "...";
  const std::string near = nearest_name(form.head(), known);
  std::string sentence =
      name.empty() ? "a command is a form that begins with its name" : "there is no command or agent " + name;
  sentence += near.empty() ? "; (help) lists them" : fmt::format("; did you mean {}?", near);
  co_return Failure{"unknown-command", sentence, name.empty() ? Datum() : Datum::symbol(name), {}};
}

Task<Evaluation> Interpreter::evaluate_form(Datum form) {
  if (const Command* command = find_command(form.head())) {
    const Evaluation outcome = co_await (this->*command->run)(form);
    co_return outcome;
  }
  if (form.size() != 2) {
    const std::string sentence =
        fmt::format("an agent is asked as ({} (OPERATION ARGUMENT ...)); (agents) lists what they offer", form.head());
    const Failure failure{"malformed", sentence, {}, {}};
    co_return show(failure, Evaluation::malformed);
  }
  const Datum operation = as_form(form[1]);
  const Evaluation outcome = co_await request(std::string(form.head()), operation);
  co_return outcome;
}

Task<bool> Interpreter::is_agent(std::string name) {
  if (name.empty() || find_command(name) != nullptr) co_return false;
  const Result<std::vector<Fact>> present =
      co_await context_.board.facts(list("agent"_sym, Datum::symbol(name), "?"_sym, "?"_sym));
  co_return present.has_value() && !present->empty();
}

Task<Evaluation> Interpreter::request(std::string agent, Datum operation) {
  const Result<Datum> answer = co_await caller_.call(agent, operation, answer_timeout);
  if (!answer) co_return show(answer.error(), Evaluation::failed);
  const std::vector<Datum> remarks = co_await remarks_on(agent, operation, *answer);
  const bool sentences = std::ranges::all_of(answer->items(), &Datum::is_string);
  std::string line = answer->size() == 0 ? "ok" : "";
  for (const Datum& value : answer->items()) {
    line += (line.empty() ? "" : sentences ? "\n" : " ") + (sentences ? std::string(value.text()) : write(value));
  }
  for (const Datum& remark : remarks) line += "\n  " + std::string(remark.text());
  say(line, fmt::format("{{\"reply\":{}}}", json_values(answer->items())));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::help(Datum form) {
  if (form.size() > 2) co_return usage("help");
  if (form.size() == 2) co_return co_await help_with(form[1]);
  for (const Command& command : Command::all()) output_(fmt::format("  {:22} {}", command.usage, command.help));
  output_("  (AGENT (OPERATION ...)) ask one agent: (robot (monitor)), (vision (get-objects));");
  output_("                         (robot (get-control)) resets an arm's alarm and switches its servos on");
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::help_with(Datum word) {
  const std::string name(word.is_symbol() ? word.text() : "");
  if (const Command* command = find_command(name)) {
    output_(fmt::format("  {:22} {}", command->usage, command->help));
    co_return Evaluation::done;
  }
  const bool present = co_await is_agent(name);
  if (!present) {
    const Failure unknown = co_await unknown_command(as_form(word));
    co_return show(unknown, Evaluation::malformed);
  }
  const std::vector<Datum> offers = co_await offers_of(word);
  for (const Datum& operation : offers) output_(fmt::format("  ({} {})", name, write(operation)));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::quit(Datum) { co_return Evaluation::quit; }

Task<Evaluation> Interpreter::ask(Datum form) {
  if (form.size() != 2) co_return usage("ask");
  const Result<Query> query = query_from_datum(form[1]);
  if (!query) co_return show(query.error(), Evaluation::malformed);
  const Result<Answers> answers = co_await context_.board.ask(*query);
  if (!answers) co_return show(answers.error());
  std::string text = answers->answers.empty() ? "no" : "";
  for (const Answer& answer : answers->answers) text += (text.empty() ? "" : "\n") + bindings_text(answer);
  say(text, fmt::format("{{\"revision\":{},\"answers\":{}}}", answers->revision, json_answers(answers->answers)));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::declare(Datum form) {
  if (form.size() != 2) co_return usage("declare");
  const Result<Relation> relation = relation_from_datum(form[1]);
  if (!relation) co_return show(relation.error(), Evaluation::malformed);
  const std::vector<Relation> relations(1, *relation);
  const Result<void> declared = co_await context_.board.declare(relations);
  if (!declared) co_return show(declared.error());
  say("declared " + relation->name, fmt::format("{{\"declared\":{}}}", json_string(relation->name)));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::tell(Datum form) {
  if (form.size() != 2) co_return usage("tell");
  const Result<Revision> told = co_await context_.board.tell(form[1]);
  if (!told) co_return show(told.error());
  say(fmt::format("told, revision {}", *told), fmt::format("{{\"revision\":{}}}", *told));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::retract(Datum form) {
  if (form.size() != 2) co_return usage("retract");
  const Result<std::vector<Fact>> fitting = co_await context_.board.facts(form[1]);
  if (!fitting) co_return show(fitting.error());
  const Result<Revision> retracted = co_await context_.board.retract(form[1]);
  if (!retracted) co_return show(retracted.error());
  say(fmt::format("retracted {}, revision {}", fitting->size(), *retracted),
      fmt::format("{{\"retracted\":{},\"revision\":{}}}", fitting->size(), *retracted));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::watch(Datum form) {
  if (form.size() != 2) co_return usage("watch");
  std::erase_if(watches_, [](const auto& entry) { return entry.second.done(); });
  if (watches_.size() >= max_watches) {
    const std::string sentence = fmt::format("{} watches run already; end one with (unwatch N)", max_watches);
    const Failure failure{"too-many", sentence, {}, {}};
    co_return show(failure);
  }
  const Result<Query> query = query_from_datum(form[1]);
  if (!query) co_return show(query.error(), Evaluation::malformed);
  Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(*query);
  if (!watch) co_return show(watch.error());
  const int number = next_watch_++;
  say(fmt::format("watch {}", number), fmt::format("{{\"watch\":{}}}", number));
  watches_.emplace(number, context_.executor.spawn(follow(number, std::move(*watch))));
  co_return Evaluation::done;
}

Task<void> Interpreter::follow(int number, std::unique_ptr<Watch> watch) {
  for (bool first = true;; first = false) {
    const Result<Change> change = co_await watch->next();
    if (!change) {
      say(fmt::format("[{}] ended: {}", number, describe(change.error())),
          fmt::format("{{\"watch\":{},\"error\":{}}}", number, json_failure(change.error())));
      co_return;
    }
    say_change(number, *change, first);
  }
}

void Interpreter::say_change(int number, const Change& change, bool first) {
  std::string text;
  const auto add = [&](const std::string& line) {
    text += fmt::format("{}[{}] {}", text.empty() ? "" : "\n", number, line);
  };
  const bool missed = change.resynchronised && !first;
  if (missed) add("changes were missed: what was shown before is void, and this stands now");
  if (change.resynchronised && change.added.empty()) add(missed ? "nothing" : "nothing yet");
  for (const Answer& answer : change.removed) add("- " + bindings_text(answer));
  for (const Answer& answer : change.added) add("+ " + bindings_text(answer));
  say(text,
      fmt::format("{{\"watch\":{},\"revision\":{},\"resynchronised\":{},\"removed\":{},\"added\":{}}}", number,
                  change.revision, change.resynchronised, json_answers(change.removed), json_answers(change.added)));
}

Task<Evaluation> Interpreter::unwatch(Datum form) {
  const bool shaped = form.size() == 2 && form[1].is_integer();
  if (!shaped) co_return usage("unwatch");
  if (watches_.erase(static_cast<int>(form[1].integer())) == 0) {
    output_(fmt::format("there is no watch {}", form[1].integer()));
    co_return Evaluation::failed;
  }
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
