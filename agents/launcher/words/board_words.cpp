// The words that talk to a board: repl, and each of tell, retract, ask, watch, goal and why as one form for the prompt.

#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/command_line/key_option.hpp"
#include "agents/launcher/command_line/moment.hpp"
#include "agents/launcher/command_line/word_tools.hpp"
#include "agents/launcher/supervision/local_cell.hpp"
#include "agents/launcher/supervision/readiness.hpp"
#include "agents/launcher/supervision/run_directory.hpp"
#include "agents/launcher/words/words.hpp"
#include "agents/repl/json_answers.hpp"
#include "agents/repl/repl.hpp"
#include "blackboard/journal_file.hpp"
#include "blackboard/recorded_board.hpp"
#include "blackboard/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr Duration board_timeout = 5s;

struct BoardChoices {
  std::string board;  // an address
  std::string cell;   // the name of a running cell
  std::string key;    // the file of a secret key
};

// How a word is to talk: `stay` until interrupted, also when the forms are done.
struct Manner {
  Interpreter::Patience patience = Interpreter::Patience::ended;
  Style style = Style::text;
  bool stay = false;
  bool recorded = false;  // nobody is there, and nobody is told of us
};

struct ReplChoices {
  BoardChoices board;
  std::string cell_file;
  std::vector<std::string> forms;
  std::vector<std::string> agents;
  std::uint64_t seed = 1;
};

int status_of(Evaluation evaluation) {
  switch (evaluation) {
    case Evaluation::done:
    case Evaluation::quit:
      return exit_reached;
    case Evaluation::malformed:
      return exit_usage;
    case Evaluation::refused:
      return exit_refused;
    case Evaluation::failed:
      break;
  }
  return exit_failed;
}

int complain_as(Style style, const Failure& failure, ExitCode code) {
  if (style == Style::text) return complain(failure, code);
  fmt::print("{}\n", json_error(failure));
  return code;
}

// Where the board is, and with which key one comes there.
struct Destination {
  std::string address;
  std::string key;
};

Result<Destination> destination(const BoardChoices& choices) {
  if (!choices.board.empty()) return Destination{choices.board, choices.key};
  const Result<RunState> run = find_run(choices.cell);
  if (!run) return fail(run);
  return Destination{run->board_address, choices.key.empty() ? run->key : choices.key};
}

// The forms, or the prompt where there are none, on any board.
class Session {
 public:
  Session(Executor& executor, Board& board, Manner manner)
      : manner_(manner),
        context_{fmt::format("prompt-{}", getpid()), "localhost", executor, board, Random(1)},
        service_(context_, contract_from_text("(contract prompt)").value()),
        interpreter_(
            context_, service_, [this](const std::string& line) { print(line); }, manner.patience, manner.style) {}

  // `wait_for_teaching`: the forms are evaluated when the person of the cell has taught its objects.
  int run(const std::vector<std::string>& forms, bool wait_for_teaching) {
    const Job job = context_.executor.spawn(talk(forms, wait_for_teaching));
    context_.executor.run_until([&job] { return job.done(); });
    return status_;
  }

 private:
  void print(const std::string& line) {
    if (terminal_ != nullptr) {
      terminal_->print(line);
      return;
    }
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }

  Task<Result<void>> reach_board() {
    const Datum anybody = list("agent"_sym, "?"_sym, "?"_sym, "?"_sym);
    const Result<std::vector<Fact>> there = co_await context_.board.facts(anybody);
    if (!there && there.error().symbol != "undeclared-relation") co_return fail(there);
    if (manner_.recorded) co_return {};
    co_return co_await service_.start();
  }

  Task<void> talk(std::vector<std::string> forms, bool wait_for_teaching) {
    const Result<void> reached = co_await reach_board();
    if (!reached) {
      const bool there = reached.error().symbol == "not-permitted";
      status_ = complain_as(manner_.style, reached.error(), there ? exit_failed : exit_unavailable);
      co_return;
    }
    if (wait_for_teaching) {
      const Result<void> taught = co_await await_teaching(context_.board, context_.executor);
      if (!taught) {
        status_ = complain_as(manner_.style, taught.error(), exit_unavailable);
        co_return;
      }
    }
    if (!forms.empty()) {
      const Evaluation end = co_await run_forms(interpreter_, std::move(forms));
      status_ = status_of(end);
      const bool watching = manner_.stay && status_ == exit_reached;
      while (watching) co_await sleep(context_.executor, 1s);
      co_return;
    }
    Terminal terminal(context_.executor, "pizarra> ");
    terminal_ = &terminal;
    co_await run_prompt(context_, interpreter_, terminal);
    terminal_ = nullptr;
    if (terminal.interrupted()) status_ = exit_interrupted;
  }

  Manner manner_;
  AgentContext context_;
  Service service_;
  Terminal* terminal_ = nullptr;
  Interpreter interpreter_;
  int status_ = exit_reached;
};

int talk_to(const Destination& to, const std::vector<std::string>& forms, Manner manner) {
  RealExecutor executor;
  const Result<std::optional<ClientKeys>> keys = keys_from(to.key);
  if (!keys) return complain_as(manner.style, keys.error(), exit_usage);
  const auto board =
      RemoteBoard::connect(executor, to.address, fmt::format("prompt-{}", getpid()), board_timeout, *keys);
  if (!board) return complain_as(manner.style, board.error(), exit_usage);
  return Session(executor, **board, manner).run(forms, false);
}

bool is_script(const ReplChoices& choices) { return !choices.forms.empty() || isatty(STDIN_FILENO) == 0; }

// Who types goes on typing while a goal is pursued; a script waits.
Manner manner_of(const ReplChoices& choices) {
  return {.patience = is_script(choices) ? Interpreter::Patience::ended : Interpreter::Patience::accepted};
}

int talk_to_own_cell(const ReplChoices& choices) {
  const Result<CellDescription> cell = read_cell_file(choices.cell_file);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<void> sound = check(world_config(*cell, choices.seed));
  if (!sound) return complain(sound.error(), exit_usage);
  RealExecutor executor;
  LocalCell local(executor, *cell, choices.seed);
  const bool whole = choices.agents.empty();
  for (const std::string& kind : whole ? agent_kinds() : choices.agents) {
    const Result<void> started = local.start(kind);
    if (!started) return complain(started.error(), exit_usage);
  }
  const std::unique_ptr<Board> view = local.board().view("prompt");
  return Session(executor, *view, manner_of(choices)).run(choices.forms, whole && is_script(choices));
}

int run_repl(const ReplChoices& choices) {
  const bool own = !choices.agents.empty() || (choices.board.board.empty() && running_cells().empty());
  if (own) return talk_to_own_cell(choices);
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain(to.error(), exit_unavailable);
  return talk_to(*to, choices.forms, manner_of(choices));
}

void add_board_options(CLI::App* word, BoardChoices& choices) {
  word->add_option("--board", choices.board, "The board's address; that of the cell that runs here otherwise");
  word->add_option("--cell", choices.cell, "Which cell that runs here, by name");
  add_key_option(word, choices.key);
  word->footer(exit_code_help);
}

struct FormWord {
  const char* name;
  const char* argument;  // empty: none
  const char* help;
};

constexpr FormWord form_words[] = {
    {"tell", "FACT", "Tell a fact"},
    {"retract", "PATTERN", "Retract every fact that fits"},
    {"ask", "QUERY", "Ask what holds: (on ?x ?y), (and (on ?x ?y) (clear ?x))"},
    {"watch", "QUERY", "Show what holds and every change, until interrupted"},
    {"goal", "GOAL", "Give the cell a goal and wait for its end: FACT, (and FACT ...) or several FACTs"},
    {"why", "", "Ask the coordinator why it does what it does"},
};

struct FormChoices {
  BoardChoices board;
  std::vector<std::string> arguments;
  bool json = false;
  // Of `ask`.
  std::string at;
  std::string journal;
};

// The query with the moment it is about, for a board that keeps a journal.
Result<std::string> ask_at(const Source& typed, const std::string& at) {
  const auto now = std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
  const Result<Moment> moment = moment_from_text(at, Time(now.time_since_epoch()));
  if (!moment) return fail(moment);
  if (typed.data().size() != 1) return fail("malformed", "with --at there is one query");
  Result<Query> query = query_from_datum(typed.data().front());
  if (!query) return fail(query);
  query->at = *moment;
  return write(list("ask"_sym, query_to_datum(*query)));
}

int ask_journal(const std::string& form, const FormChoices& choices, Style style) {
  const Result<LineStart> end = end_of_journal(choices.journal);
  if (!end) return complain_as(style, end.error(), exit_usage);
  const Result<Moment> moment = choices.at.empty() ? Moment{} : moment_from_text(choices.at, end->when);
  if (!moment) return complain_as(style, moment.error(), exit_usage);
  RealExecutor executor;
  const auto board = RecordedBoard::open(executor, choices.journal, *moment);
  if (!board) return complain_as(style, board.error(), exit_usage);
  return Session(executor, **board, {.style = style, .recorded = true}).run({form}, false);
}

int run_form(const FormWord& word, const FormChoices& choices) {
  const Style style = choices.json ? Style::json : Style::text;
  const std::string typed = fmt::format("{}", fmt::join(choices.arguments, " "));
  // Here, so that an error shows what was typed, and not the form that is made of it.
  const Result<Source> readable = read_source(typed, "input");
  if (!readable) return complain_as(style, readable.error(), exit_usage);
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
  const bool stay = std::string_view(word.name) == "watch";
  return talk_to(*to, {form}, {.style = style, .stay = stay});
}

void add_form_word(CLI::App& app, int& status, const FormWord& word) {
  auto choices = std::make_shared<FormChoices>();
  CLI::App* added = app.add_subcommand(word.name, word.help);
  if (*word.argument != '\0') added->add_option(word.argument, choices->arguments)->required();
  added->add_flag("--json", choices->json, "One JSON object a line");
  add_board_options(added, choices->board);
  if (std::string_view(word.name) == "ask") {
    added
        ->add_option("--at", choices->at,
                     "What held then: a revision, 90s, 5min, 2h, 1d ago, 2026-11-21T12:30:00; of a "
                     "board that keeps a journal")
        ->type_name("MOMENT");
    added->add_option("--journal", choices->journal, "Ask this journal in place of a board")->check(CLI::ExistingFile);
  }
  added->callback([&word, choices, &status] { status = run_form(word, *choices); });
}

}  // namespace

void add_board_words(CLI::App& app, int& status) {
  auto choices = std::make_shared<ReplChoices>();
  choices->cell_file = shipped_file("examples/01-blocks/cell.scm");
  CLI::App* repl = app.add_subcommand(
      "repl", "A prompt on the cell that runs here, or, when none does, on the demo cell in this process.");
  repl->add_option("file", choices->cell_file, "The cell file of the cell in this process")
      ->check(CLI::ExistingFile)
      ->capture_default_str();
  repl->add_option("--eval", choices->forms, "Evaluate this form and end; may be given several times");
  repl->add_option("--agents", choices->agents, "Run just these agents on a board in this process: vision,robot")
      ->delimiter(',')
      ->check(CLI::IsMember(agent_kinds()));
  repl->add_option("--seed", choices->seed, "What chance begins from")->check(seed_check())->capture_default_str();
  add_board_options(repl, choices->board);
  repl->callback([choices, &status] { status = run_repl(*choices); });
  for (const FormWord& word : form_words) add_form_word(app, status, word);
}

}  // namespace pizarra
