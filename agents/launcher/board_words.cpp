// The words that talk to a board: repl, and each of tell, retract, ask, watch, goal and why as one form for the prompt.

#include <fmt/format.h>
#include <unistd.h>

#include "agents/launcher/local_cell.hpp"
#include "agents/launcher/run_directory.hpp"
#include "agents/launcher/words.hpp"
#include "agents/repl/repl.hpp"
#include "blackboard/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"

namespace pizarra {

namespace {

constexpr Duration board_timeout = 5s;
constexpr Duration teaching_patience = 120s;

struct BoardChoices {
  std::string board;  // an address
  std::string cell;   // the name of a running cell
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

Result<std::string> board_address(const BoardChoices& choices) {
  if (!choices.board.empty()) return choices.board;
  const Result<RunState> run = find_run(choices.cell);
  if (!run) return fail(run);
  return run->board_address;
}

// The forms, or the prompt where there are none, on any board.
class Session {
 public:
  // `stay`: until interrupted, also when the forms are done.
  Session(Executor& executor, Board& board, Interpreter::Patience patience, bool stay = false)
      : stay_(stay),
        context_{fmt::format("prompt-{}", getpid()), "localhost", executor, board, Random(1)},
        service_(context_, contract_from_text("(contract prompt)").value()),
        interpreter_(
            context_, service_, [this](const std::string& line) { print(line); }, patience) {}

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
    co_return co_await service_.start();
  }

  // What a goal is refused with while the person of the cell teaches its objects: few are known yet.
  Task<Result<void>> check_taught() {
    const Datum person = list("agent"_sym, "?"_sym, "person"_sym, "?"_sym);
    const Result<std::vector<Fact>> there = co_await context_.board.facts(person);
    if (!there || there->empty()) co_return {};
    const Datum said = list("person"_sym, "?"_sym, "?"_sym);
    const Result<std::vector<Fact>> says = co_await context_.board.facts(said);
    const bool begun = says.has_value() && !says->empty();
    if (begun && !says->front().datum[1].is_symbol("teaching")) co_return {};
    co_return fail("not-ready", "the objects are still being taught; `up` says when it is ready for goals");
  }

  Task<void> await_teaching() {
    const Time deadline = context_.executor.now() + teaching_patience;
    const Datum done = list("person"_sym, "done"_sym, "?"_sym);
    while (context_.executor.now() < deadline) {
      const Result<std::vector<Fact>> taught = co_await context_.board.facts(done);
      if (taught.has_value() && !taught->empty()) co_return;
      co_await sleep(context_.executor, 100ms);
    }
  }

  Task<void> talk(std::vector<std::string> forms, bool wait_for_teaching) {
    const Result<void> reached = co_await reach_board();
    if (!reached) {
      status_ = complain(reached.error(), exit_unavailable);
      co_return;
    }
    if (wait_for_teaching) co_await await_teaching();
    const bool goal_alone = !wait_for_teaching && forms.size() == 1 && forms.front().starts_with("(goal ");
    if (goal_alone) {
      const Result<void> taught = co_await check_taught();
      if (!taught) {
        status_ = complain(taught.error(), exit_refused);
        co_return;
      }
    }
    if (!forms.empty()) {
      const Evaluation end = co_await run_forms(interpreter_, std::move(forms));
      status_ = status_of(end);
      const bool watching = stay_ && status_ == exit_reached;
      while (watching) co_await sleep(context_.executor, 1s);
      co_return;
    }
    Terminal terminal(context_.executor, "pizarra> ");
    terminal_ = &terminal;
    co_await run_prompt(context_, interpreter_, terminal);
    terminal_ = nullptr;
    if (terminal.interrupted()) status_ = exit_interrupted;
  }

  bool stay_;
  AgentContext context_;
  Service service_;
  Terminal* terminal_ = nullptr;
  Interpreter interpreter_;
  int status_ = exit_reached;
};

int talk_to(const std::string& address, const std::vector<std::string>& forms, Interpreter::Patience patience,
            bool stay = false) {
  RealExecutor executor;
  const auto board = RemoteBoard::connect(executor, address, fmt::format("prompt-{}", getpid()), board_timeout);
  if (!board) return complain(board.error(), exit_usage);
  return Session(executor, **board, patience, stay).run(forms, false);
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
  const auto patience = choices.forms.empty() ? Interpreter::Patience::accepted : Interpreter::Patience::ended;
  const std::unique_ptr<Board> view = local.board().view("prompt");
  return Session(executor, *view, patience).run(choices.forms, whole && !choices.forms.empty());
}

int run_repl(const ReplChoices& choices) {
  const bool own = !choices.agents.empty() || (choices.board.board.empty() && running_cells().empty());
  if (own) return talk_to_own_cell(choices);
  const Result<std::string> address = board_address(choices.board);
  if (!address) return complain(address.error(), exit_unavailable);
  const auto patience = choices.forms.empty() ? Interpreter::Patience::accepted : Interpreter::Patience::ended;
  return talk_to(*address, choices.forms, patience);
}

void add_board_options(CLI::App* word, BoardChoices& choices) {
  word->add_option("--board", choices.board, "The board's address; that of the cell that runs here otherwise");
  word->add_option("--cell", choices.cell, "Which cell that runs here, by name");
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

int run_form(const FormWord& word, const std::vector<std::string>& arguments, const BoardChoices& choices) {
  const Result<std::string> address = board_address(choices);
  if (!address) return complain(address.error(), exit_unavailable);
  std::string form = std::string("(") + word.name;
  for (const std::string& argument : arguments) form += " " + argument;
  std::vector<std::string> forms{form + ")"};
  const bool stay = std::string_view(word.name) == "watch";
  return talk_to(*address, forms, Interpreter::Patience::ended, stay);
}

void add_form_word(CLI::App& app, int& status, const FormWord& word) {
  auto choices = std::make_shared<BoardChoices>();
  auto arguments = std::make_shared<std::vector<std::string>>();
  CLI::App* added = app.add_subcommand(word.name, word.help);
  if (*word.argument != '\0') added->add_option(word.argument, *arguments)->required();
  add_board_options(added, *choices);
  added->callback([&word, choices, arguments, &status] { status = run_form(word, *arguments, *choices); });
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
