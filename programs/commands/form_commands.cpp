// The words that put one form to a board: declare, tell, retract, ask, watch, goal and why.

#include <fmt/format.h>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/memory/recorded_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/moment.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/recall.hpp"
#include "programs/story/goal_text.hpp"

namespace pizarra::programs {

namespace {

struct FormWord {
  const char* name;
  const char* argument;
  const char* argument_help;
  const char* help;
  const char* example;
  bool asks_agents = false;  // not the board alone
};

constexpr FormWord form_words[] = {
    {"declare", "RELATION", "(relation NAME ((ARGUMENT TYPE) ...) (key ARGUMENT ...)); `(durable)` may follow",
     "Declare a relation, so that its facts can be told",
     "declare '(relation seen ((name symbol) (x number)) (key name))'"},
    {"tell", "FACT", "(NAME VALUE ...)", "Tell a fact", "tell '(on circle triangle)'"},
    {"retract", "PATTERN", "A fact in which ? stands for anything", "Retract every fact that matches",
     "retract '(on circle ?)'"},
    {"ask", "QUERY", "A pattern, or (and PATTERN ...) with (not PATTERN), (< ?x 900), (order ?x), (limit N)",
     "Ask which facts match: (on ?x ?y), (and (on ?x ?y) (clear ?x))", "ask '(and (on ?x ?y) (clear ?x))'"},
    {"watch", "QUERY", "A pattern, or (and PATTERN ...) with (not PATTERN) and (< ?x 900)",
     "Show the facts that match and every change, until interrupted", "watch '(on ?x ?y)'"},
    {"goal", "GOAL", "Facts that shall hold, quoted for the shell",
     "Give the cell a goal and wait for its end: FACT, (and FACT ...) or several FACTs", "goal '(on circle triangle)'",
     true},
    {"why", "PATTERN", "Facts, or `not GOAL`; without it the coordinator says what it does and why",
     "Ask the coordinator for its reasons, why the facts that match are on the board, or why a goal does not hold",
     "why not '(on circle triangle)'", true},
};

struct FormChoices {
  BoardChoices board;
  std::vector<std::string> arguments;
  bool json = false;
  // Of `ask`.
  std::string at;
  std::string journal;
  bool old = false;
};

// The query, with the moment that it asks about, for a board that keeps a journal.
Result<std::string> ask_at(const Source& typed, const std::string& at) {
  const auto now = std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
  const Result<Moment> moment = moment_from_text(at, Time(now.time_since_epoch()));
  if (!moment) return fail(moment);
  Result<Query> query = query_from_datum(typed.data().front());
  if (!query) return fail(query);
  query->at = *moment;
  return write(list("ask"_sym, query_to_datum(*query)));
}

int ask_journal(const std::string& form, const FormChoices& choices, repl::Style style) {
  const Result<journal::LineStart> end = journal::end_of_journal(choices.journal);
  if (!end) return complain_as(style, end.error(), exit_usage);
  const Result<Moment> moment = choices.at.empty() ? Moment{} : moment_from_text(choices.at, end->when);
  if (!moment) return complain_as(style, moment.error(), exit_usage);
  RealExecutor executor;
  const auto board = memory::RecordedBoard::open(executor, choices.journal, *moment);
  if (!board) return complain_as(style, board.error(), exit_usage);
  return BoardSession(executor, **board, {.style = style, .present = false}).run({form});
}

int ask_even_if_old(const Source& typed, const Destination& to, repl::Style style) {
  const Result<Query> query = query_from_datum(typed.data().front());
  if (!query) return complain_as(style, query.error(), exit_usage);
  return print_recalled(to, *query, style);
}

// The words behind `goal` and `why` are of several kinds; every other command takes one form.
Result<void> check_form(const FormWord& word, const Source& typed) {
  const bool one_list = typed.data().size() == 1 && typed.data().front().is_list();
  if (word.asks_agents || one_list) return {};
  return fail("malformed",
              fmt::format("{} takes one {} in parentheses: pizarra {}", word.name, word.argument, word.example));
}

int run_form(const FormWord& word, const FormChoices& choices) {
  const repl::Style style = choices.json ? repl::Style::json : repl::Style::text;
  const std::string typed = fmt::format("{}", fmt::join(choices.arguments, " "));
  if (std::string_view(word.name) == "goal") {
    const Result<void> goal = check_typed_goal(typed);
    if (!goal) return complain_as(style, goal.error(), exit_usage);
  }
  // Here, so that an error shows what was typed, and not the form that is made of it.
  const Result<Source> readable = read_source(typed, "input");
  if (!readable) return complain_as(style, readable.error(), exit_usage);
  const Result<void> whole = check_form(word, *readable);
  if (!whole) return complain_as(style, whole.error(), exit_usage);
  // On a line of its own: a comment at its end must not swallow the parenthesis.
  std::string form = fmt::format("({} {}\n)", word.name, typed);
  if (!choices.journal.empty()) return ask_journal(form, choices, style);
  if (!choices.at.empty()) {
    Result<std::string> then = ask_at(*readable, choices.at);
    if (!then) return complain_as(style, then.error(), exit_usage);
    form = std::move(*then);
  }
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain_as(style, to.error(), exit_unavailable);
  if (choices.old) return ask_even_if_old(*readable, *to, style);
  const bool stay = std::string_view(word.name) == "watch";
  return talk_to(*to, {form}, {.style = style, .stay = stay, .present = word.asks_agents});
}

void add_form_command(CLI::App& app, int& status, const FormWord& word) {
  auto choices = std::make_shared<FormChoices>();
  CLI::App* added = app.add_subcommand(word.name, word.help);
  const bool alone = std::string_view(word.name) == "why";
  added->add_option(word.argument, choices->arguments, word.argument_help)->required(!alone);
  added->add_flag("--json", choices->json, "Print one JSON object a line");
  add_board_options(added, choices->board);
  added->footer(help_footer(word.example));
  if (std::string_view(word.name) == "ask") {
    added
        ->add_option("--at", choices->at,
                     "Ask what held at a moment: a revision, 90s, 5min, 2h or 1d ago, 2026-11-21T12:30:00. The "
                     "board must keep a journal")
        ->check(moment_check());
    added->add_option("--journal", choices->journal, "Ask this journal instead of a board")
        ->check(CLI::ExistingFile)
        ->excludes("--board");
    added
        ->add_flag("--old", choices->old,
                   "Be answered also by a board that may have been replaced, and told how old that is")
        ->excludes("--at", "--journal");
  }
  added->callback([&word, choices, &status] { status = run_form(word, *choices); });
}

}  // namespace

void add_form_commands(CLI::App& app, int& status) {
  for (const FormWord& word : form_words) add_form_command(app, status, word);
}

}  // namespace pizarra::programs
