// `replay`: a journal as a board that can be asked, watched and played on.

#include <cmath>
#include <fmt/format.h>
#include <unistd.h>

#include "agents/repl/answer_text.hpp"
#include "agents/repl/repl.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/moment.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/export_journal.hpp"
#include "programs/commands/kept_journal.hpp"

namespace pizarra::programs {

namespace {

struct ReplayChoices {
  KeptJournal journal;
  std::string at;
  std::vector<std::string> forms;
  std::string mcap;
  std::string pictures;
  bool json = false;
};

constexpr const char* own_commands =
    "(moment)                  the revision played back to, and its time\n"
    "(step) (step N)           the next revision, or N of them\n"
    "(play) (play SPEED)       on to the end, as fast as it went, or SPEED times as fast\n"
    "(at \"MOMENT\") (at N)      another moment, before or after: 120, \"90s\" before the end, \"@12.5\"\n"
    "Then what only asks:";

// The board at one moment, and who talks to it. Going back makes another.
struct Recorded {
  Recorded(Executor& executor, std::unique_ptr<memory::RecordedBoard> recorded, const repl::Output& output,
           repl::Style style)
      : board(std::move(recorded)),
        context{fmt::format("replay-{}", getpid()), "localhost", executor, *board, Random(1)},
        service(context, runtime::contract_from_text("(contract replay)").value()),
        interpreter(context, service, output, repl::Patience::ended, style) {}
  std::unique_ptr<memory::RecordedBoard> board;
  runtime::AgentContext context;
  runtime::Service service;
  repl::Interpreter interpreter;
};

class Player {
 public:
  Player(Executor& executor, const ReplayChoices& choices) : executor_(executor), choices_(choices) {}

  // At the end where no moment is said.
  Result<void> open(const std::optional<std::string>& at) {
    const Result<journal::LineStart> end = end_of(choices_.journal);
    if (!end) return fail(end);
    const Result<Moment> moment = at ? moment_from_text(*at, end->when) : Moment{};
    if (!moment) return fail(moment);
    Result<std::unique_ptr<memory::RecordedBoard>> board = open_recorded(executor_, choices_.journal, *moment);
    if (!board) return fail(board);
    recorded_ = std::make_unique<Recorded>(
        executor_, std::move(*board), [this](const std::string& line) { print(line); },
        choices_.json ? repl::Style::json : repl::Style::text);
    return {};
  }

  int run() {
    const Job job = executor_.spawn(choices_.forms.empty() ? talk() : evaluate_all());
    executor_.run_until([&job] { return job.done(); });
    return status_;
  }

 private:
  void print(const std::string& line) {
    if (terminal_ != nullptr) return terminal_->print(line);
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }

  Task<void> talk() {
    repl::Terminal terminal(executor_, "replay> ");
    terminal.words = [this]() -> const std::set<std::string>& { return recorded_->interpreter.words(); };
    terminal_ = &terminal;
    repl::Evaluation outcome = repl::Evaluation::done;
    while (outcome != repl::Evaluation::quit) {
      std::optional<std::string> typed = co_await terminal.read();
      if (!typed) break;
      outcome = co_await evaluate(std::move(*typed));
      co_await recorded_->interpreter.learn_words();
    }
    terminal_ = nullptr;
    if (terminal.interrupted()) status_ = exit_interrupted;
  }

  Task<void> evaluate_all() {
    for (const std::string& form : choices_.forms) {
      const repl::Evaluation outcome = co_await evaluate(form);
      // Changes of a step that watchers see are shown before the next form.
      co_await sleep(executor_, Duration::zero());
      if (outcome == repl::Evaluation::quit) co_return;
      if (outcome == repl::Evaluation::malformed) status_ = exit_usage;
      if (outcome == repl::Evaluation::failed) status_ = exit_failed;
      if (outcome != repl::Evaluation::done) co_return;
    }
  }

  Task<repl::Evaluation> evaluate(std::string text) {
    const Result<Source> forms = read_source(text, "input");
    // The prompt says what is wrong with it.
    if (!forms) co_return co_await recorded_->interpreter.evaluate(std::move(text));
    repl::Evaluation outcome = repl::Evaluation::done;
    for (const Datum& form : forms->data()) {
      outcome = co_await evaluate_form(form);
      if (outcome != repl::Evaluation::done) break;
    }
    co_return outcome;
  }

  // One of our own commands, or what the prompt knows.
  Task<repl::Evaluation> evaluate_form(Datum form) {
    if (form.is_form("moment") && form.size() == 1) co_return tell_moment();
    if (form.is_form("step") && form.size() <= 2) co_return step(form);
    if (form.is_form("at") && form.size() == 2) co_return go_to(form[1]);
    const bool plays = form.is_form("play") && form.size() <= 2;
    if (plays) co_return co_await play(form);
    if (form.is_form("help") && form.size() == 1 && !choices_.json) print(own_commands);
    std::string text = write(form);
    co_return co_await recorded_->interpreter.evaluate(std::move(text));
  }

  repl::Evaluation complain_of(const Failure& failure, repl::Evaluation outcome) {
    print(choices_.json ? json_error(failure) : describe(failure));
    return outcome;
  }

  repl::Evaluation tell_moment() {
    const journal::LineStart moment = recorded_->board->moment();
    const auto microseconds = moment.when.time_since_epoch().count();
    print(choices_.json ? fmt::format("{{\"revision\":{},\"microseconds\":{}}}", moment.revision, microseconds)
                        : fmt::format("revision {} at {}", moment.revision, time_text(moment.when)));
    return repl::Evaluation::done;
  }

  repl::Evaluation step(const Datum& form) {
    const std::int64_t steps = form.size() == 2 ? form[1].integer() : 1;
    if (steps < 1) {
      return complain_of({"malformed", "(step N) takes a whole number above 0", {}, {}}, repl::Evaluation::malformed);
    }
    for (std::int64_t n = 0; n < steps; ++n) {
      const Result<bool> stepped = recorded_->board->step();
      if (!stepped) return complain_of(stepped.error(), repl::Evaluation::failed);
      if (!*stepped) break;
    }
    return tell_moment();
  }

  repl::Evaluation go_to(const Datum& moment) {
    if (!moment.is_string() && !moment.is_integer()) {
      return complain_of({"malformed", "(at MOMENT) takes a revision or a string", {}, {}},
                         repl::Evaluation::malformed);
    }
    const std::string text = moment.is_string() ? std::string(moment.text()) : std::to_string(moment.integer());
    const Result<void> opened = open(text);
    if (!opened) return complain_of(opened.error(), repl::Evaluation::failed);
    return tell_moment();
  }

  Task<repl::Evaluation> play(Datum form) {
    const double speed = form.size() == 2 ? form[1].number() : 1;
    if (!(speed > 0)) {
      const Failure failure{"malformed", "(play SPEED) takes a number above 0", {}, {}};
      co_return complain_of(failure, repl::Evaluation::malformed);
    }
    Time at = recorded_->board->moment().when;
    for (std::optional<Time> next = recorded_->board->next(); next; next = recorded_->board->next()) {
      const auto pause = std::chrono::duration_cast<Duration>((*next - at) / speed);
      if (pause > Duration::zero()) co_await sleep(executor_, pause);
      at = *next;
      const Result<bool> stepped = recorded_->board->step();
      if (!stepped) co_return complain_of(stepped.error(), repl::Evaluation::failed);
    }
    co_return tell_moment();
  }

  Executor& executor_;
  const ReplayChoices& choices_;
  std::unique_ptr<Recorded> recorded_;
  repl::Terminal* terminal_ = nullptr;
  int status_ = exit_reached;
};

int run_export(Executor& executor, const ReplayChoices& choices) {
  const Result<journal::LineStart> end = end_of(choices.journal);
  if (!end) return complain(end.error(), exit_usage);
  const Result<Moment> from = choices.at.empty() ? Moment{.revision = 0} : moment_from_text(choices.at, end->when);
  if (!from) return complain(from.error(), exit_usage);
  const Result<std::uint64_t> messages =
      export_journal(executor, choices.journal, *from, choices.pictures, choices.mcap);
  if (!messages) return complain(messages.error(), exit_usage);
  fmt::print("{}: {} messages\n", choices.mcap, *messages);
  return exit_reached;
}

int run_replay(const ReplayChoices& choices) {
  RealExecutor executor;
  if (!choices.mcap.empty()) return run_export(executor, choices);
  Player player(executor, choices);
  const Result<void> opened = player.open(choices.at.empty() ? std::nullopt : std::optional(choices.at));
  if (!opened) return complain(opened.error(), exit_usage);
  return player.run();
}

}  // namespace

void add_replay_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ReplayChoices>();
  CLI::App* replay =
      app.add_subcommand("replay", "Open a journal as a board: ask it, watch it, step through it and play it on.");
  add_kept_journal(*replay, choices->journal,
                   "What `board --journal`, `up` or `demo --journal` has kept, or a log: etcd://A,B,C/CELL");
  replay
      ->add_option("--at", choices->at,
                   "Begin at this moment: a revision, 90s, 5min, 2h, 1d before the end, "
                   "2026-11-21T12:30:00, or @SECONDS of its clock; the end otherwise")
      ->check(moment_check());
  replay->add_option("--eval", choices->forms, "Evaluate this form and end; may be repeated");
  replay
      ->add_option("--mcap", choices->mcap,
                   "Write the journal, from --at or else its beginning, as an MCAP file for Foxglove, and end")
      ->excludes("--eval");
  replay
      ->add_option("--pictures", choices->pictures,
                   "With --mcap: the folder in which a console kept what was seen, as /camera and /annotated")
      ->check(CLI::ExistingDirectory)
      ->needs("--mcap");
  replay->add_flag("--json", choices->json, "Print one JSON object a line");
  replay->footer(help_footer("replay run.txt --at @60 --eval '(ask (on ?x ?y))'"));
  replay->callback([choices, &status] { status = run_replay(*choices); });
}

}  // namespace pizarra::programs
