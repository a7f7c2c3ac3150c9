#include "programs/chaos/chaos_run.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>

#include "agents/runtime/caller.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "programs/chaos/fault_player.hpp"
#include "programs/chaos/observers.hpp"
#include "programs/chaos/peek.hpp"
#include "programs/chaos/verdict.hpp"
#include "programs/story/recorder.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::chaos {

namespace {

constexpr Duration play_pause = 50ms;
constexpr Duration teaching_time = 120s;
constexpr Duration goal_timeout = 5s;
constexpr Duration mark_pause = 1s;
constexpr Duration board_patience = 10s;
constexpr Duration power_cut = 300ms;  // at the end of each run

// Gives the goals, one after another, waits for what becomes of them and judges it.
class Play {
 public:
  Play(ChaosCell& cell, const ChaosStory& story, std::vector<Fault> faults, const story::Judge& judge,
       simulation::WorldConfig config, story::Narrator& narrator)
      : cell_(cell),
        story_(story),
        narrator_(narrator),
        director_(cell, "director"),
        bystander_(cell, "bystander"),
        observers_(
            cell, judge,
            [this](Time when, const std::string& kind, const std::string& sentence) {
              narrator_.say(when, kind, sentence);
            },
            [this] { return begun_ != Time{} && player_.is_quiet(); }),
        context_{"director", "localhost", director_.process, *director_.board, Random(story.seed).split("director")},
        service_(context_, runtime::contract_from_text("(contract director)").value()),
        caller_(context_, service_),
        standing_by_{"bystander", "localhost", bystander_.process, *bystander_.board,
                     Random(story.seed).split("bystander")},
        bystanders_(standing_by_, runtime::contract_from_text("(contract bystander)").value()),
        player_(cell, bystander_, caller_, std::move(faults),
                [this](const std::string& fault) { narrator_.say(cell_.time().now(), "fault", fault); }),
        verdict_(cell.time(), judge, std::move(config), observers_, player_) {}

  Task<void> run() {
    co_await play();
    co_await await_board();
    observers_.check_marks();
    note_coverage();
    co_await cut_power();
    result_.unsafe = observers_.unsafe();
    if (!result_.unsafe.empty()) {
      result_.kind = RunResult::Kind::failed;
      result_.why += (result_.why.empty() ? "" : "; ") + result_.unsafe.front();
    }
  }
  const RunResult& result() const { return result_; }

 private:
  Task<void> play() {
    observers_.begin();
    tell_silence_limit();
    const Result<void> prepared = co_await prepare();
    if (!prepared) {
      result_.why = describe(prepared.error());
      co_return;
    }
    const Job marks = director_.process.spawn(tell_marks());
    player_.begin();
    const Job phase = cell_.time().spawn(end_of_faults());
    result_.kind = RunResult::Kind::reached;
    for (const std::vector<Datum>& goal : story_.goals) {
      const bool well = co_await pursue(goal);
      if (!well) co_return;
    }
  }

  void tell_silence_limit() {
    const std::optional<Duration> limit = cell_.world().silence_limit;
    const std::string says = limit ? fmt::format("stops its arm after {} ms of silence", limit->count() / 1000)
                                   : "moves on to the end of its motion where it hears nothing";
    narrator_.say(cell_.time().now(), "world", "the arm's controller " + says);
  }

  Task<Result<void>> prepare() {
    const Result<void> started = co_await service_.start();
    if (!started) co_return started;
    // Who commands an arm is present.
    const Result<void> present = co_await bystanders_.start();
    if (!present) co_return present;
    const std::vector<Relation> relations = {
        relation_from_datum(read_one("(relation chaos-mark ((n integer)) (key n) (durable))").value()).value(),
        relation_from_datum(read_one("(relation stop ((who symbol) (reason string)) (key who) (durable))").value())
            .value()};
    const Result<void> declared = co_await director_.board->declare(relations);
    if (!declared) co_return declared;
    const Time deadline = cell_.time().now() + teaching_time;
    while (facts_of(cell_.board(), "(person done ?)").empty()) {
      if (cell_.time().now() > deadline) co_return fail("not-taught", "the objects were not learned in time");
      co_await sleep(cell_.time(), play_pause);
    }
    co_return {};
  }

  // What the board says that it keeps.
  Task<void> tell_marks() {
    for (std::int64_t mark = 1;; ++mark) {
      Transaction telling;
      telling.tell(list("chaos-mark"_sym, mark));
      const Result<Revision> told = co_await director_.board->transact(std::move(telling));
      if (told) observers_.acknowledged(mark);
      co_await sleep(director_.process, mark_pause);
    }
  }

  Task<void> end_of_faults() {
    const auto length = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(story_.fault_phase_s));
    co_await sleep(cell_.time(), length);
    co_await player_.end();
    narrator_.say(cell_.time().now(), "fault", "the faults end: all is well from now on");
    quiet_ = cell_.time().now();
  }

  // Whether it ended as it should.
  Task<bool> pursue(std::vector<Datum> goal) {
    begun_ = cell_.time().now();
    const std::optional<std::int64_t> number = co_await give(goal);
    if (!number) {
      hang("the goal was not taken");
      co_return false;
    }
    std::optional<Datum> state = co_await await_end(*number);
    while (state && (*state)[2].is_symbol("replaced")) {
      const std::optional<std::int64_t> again = given_again_after((*state)[1].integer());
      if (!again) break;
      state = co_await await_end(*again);
    }
    if (!state) {
      hang(fmt::format("goal {} did not end", *number));
      co_return false;
    }
    if ((*state)[2].is_symbol("reached")) co_return co_await judge_reached(goal);
    if ((*state)[2].is_symbol("refused")) co_return judge_refused(goal, (*state)[3]);
    failed(fmt::format("goal {} is {}", *number, (*state)[2].text()));
    co_return false;
  }

  Task<std::optional<std::int64_t>> give(std::vector<Datum> goal) {
    std::vector<Datum> request{"goal"_sym};
    request.insert(request.end(), goal.begin(), goal.end());
    const Datum operation = Datum::list(std::move(request));
    while (!is_overdue()) {
      const Result<Datum> accepted = co_await caller_.call("coordinator", operation, goal_timeout);
      if (accepted) co_return (*accepted)[0].integer();
      co_await sleep(cell_.time(), play_pause);
    }
    co_return std::nullopt;
  }

  Task<std::optional<Datum>> await_end(std::int64_t number) {
    const Datum pattern = list("goal-state"_sym, number, "?"_sym, "?"_sym);
    while (!is_overdue()) {
      const std::vector<Datum> states = facts_of(cell_.board(), pattern);
      if (!states.empty() && !states.front()[2].is_symbol("running")) co_return states.front();
      co_await sleep(cell_.time(), play_pause);
    }
    co_return std::nullopt;
  }

  // A goal is given again where no answer came in time. Both requests may be done, in either order.
  std::optional<std::int64_t> given_again_after(std::int64_t number) {
    const std::vector<Datum> own = facts_of(cell_.board(), list("goal"_sym, number, "?"_sym));
    for (const Datum& goal : facts_of(cell_.board(), "(goal ? ?)")) {
      if (!own.empty() && goal[2] == own.front()[2] && goal[1].integer() > number) return goal[1].integer();
    }
    return std::nullopt;
  }

  // A board that is away at the end is asked for what it keeps when it is back.
  Task<void> await_board() {
    if (cell_.board() != nullptr) co_return;
    co_await player_.end();
    const Time deadline = cell_.time().now() + board_patience;
    while (cell_.board() == nullptr && cell_.time().now() < deadline) {
      co_await sleep(cell_.time(), play_pause);
    }
  }

  // The board must still have every acknowledged mark when it lives again.
  Task<void> cut_power() {
    const int lives = cell_.board_lives();
    cell_.kill_board(power_cut, true, 0);
    const Time deadline = cell_.time().now() + board_patience;
    while (cell_.board_lives() == lives && cell_.time().now() < deadline) {
      co_await sleep(cell_.time(), play_pause);
    }
    co_await await_board();
    observers_.check_marks();
  }

  bool is_overdue() const {
    if (!quiet_) return false;
    return cell_.time().now() > std::max(*quiet_, begun_) + patience(story_.cell.cubes.size());
  }

  Task<bool> judge_reached(std::vector<Datum> goal) {
    const bool stands = co_await verdict_.stands(std::move(goal));
    if (!stands) observers_.add_unsafe("a goal is said to be reached, and the world does not show it");
    co_return stands;
  }

  bool judge_refused(const std::vector<Datum>& goal, const Datum& why) {
    using Kind = Verdict::Refusal::Kind;
    const Failure told = failure_from_datum(why);
    result_.why = describe(told);
    const Verdict::Refusal refusal = verdict_.on_refusal(goal, told);
    if (refusal.kind == Kind::wrong) {
      failed(fmt::format("refused, though {}: {}", refusal.wrong, result_.why));
      return false;
    }
    result_.kind = RunResult::Kind::refused;
    if (refusal.kind == Kind::right) return true;
    result_.why += "; it lies where the arm does not reach";
    result_.coverage.hit("cell refused-out-of-reach");
    return true;
  }

  void failed(std::string why) {
    result_.kind = RunResult::Kind::failed;
    result_.why = std::move(why);
  }
  void hang(std::string why) {
    failed(std::move(why));
    result_.hung = true;
  }

  void note_coverage() {
    Coverage& coverage = result_.coverage;
    coverage.add(observers_.coverage());
    coverage.add(player_.coverage());
    const simulated::Network::Counts& counts = cell_.network().counts();
    if (counts.lost_replies > 0) coverage.hit("cell reply-lost");
    if (counts.lost > 0) coverage.hit("cell frames-lost");
    if (story_.goals.size() > 1) coverage.hit("cell several-goals");
    for (const std::string& special : special_about(story_.cell)) coverage.hit("cell " + special);
    if (result_.kind == RunResult::Kind::reached) coverage.hit("cell goal-reached");
    if (result_.kind == RunResult::Kind::refused) coverage.hit("cell goal-refused");
  }

  ChaosCell& cell_;
  const ChaosStory& story_;
  story::Narrator& narrator_;
  ChaosCell::Client director_;
  ChaosCell::Client bystander_;
  Observers observers_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  runtime::AgentContext standing_by_;
  runtime::Service bystanders_;
  FaultPlayer player_;
  const Verdict verdict_;
  RunResult result_;
  Time begun_{};
  std::optional<Time> quiet_;
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<Fault> chosen(const ChaosStory& story, const PlayOptions& options) {
  if (!options.faults) return story.faults;
  std::vector<Fault> faults;
  for (const std::size_t index : *options.faults) {
    if (index < story.faults.size()) faults.push_back(story.faults[index]);
  }
  return faults;
}

}  // namespace

Result<RunResult> play(const ChaosStory& story, const PlayOptions& options, story::Narrator& narrator) {
  const Result<forms::Domain> domain = story::domain_of(story.cell);
  if (!domain) return fail(domain);
  const Result<story::Judge> judge = story::Judge::make(*domain, story.cell.cube_mm, story.cell.edges_mm());
  if (!judge) return fail(judge);
  const Result<simulation::WorldConfig> config = launcher::world_config(story.cell, story.seed);
  if (!config) return fail(config);
  const double begun_s = cpu_seconds();
  VirtualExecutor time;
  ChaosCell cell(time, story.cell, story.seed, story.clocks, options.plant);
  story::Recorder recorder(cell.streams(), narrator);
  if (!options.film_file.empty()) {
    const Result<void> filming = recorder.film(options.film_file);
    if (!filming) return fail(filming);
  }
  narrator.begin(time.now());
  const Result<void> started = cell.start_all();
  if (!started) return fail(started);
  Play play(cell, story, chosen(story, options), *judge, *config, narrator);
  const Job job = time.spawn(play.run());
  time.run_until([&] { return job.done(); });
  RunResult result = play.result();
  result.cell_s = static_cast<double>(time.now().time_since_epoch().count()) / 1e6;
  result.cpu_s = cpu_seconds() - begun_s;
  const Result<void> recorded = recorder.finish();
  if (!recorded) return fail(recorded);
  return result;
}

RunResult play_quietly(const ChaosStory& story, const PlayOptions& options) {
  story::Narrator narrator(stdout, story::Narrator::Style::silent);
  const Result<RunResult> played = play(story, options, narrator);
  if (played) return *played;
  RunResult failed;
  failed.why = describe(played.error());
  return failed;
}

std::string line_of(const RunResult& result) {
  constexpr const char* words[] = {"reached", "refused", "FAILED"};
  std::string line = fmt::format("{:<7}  {:6.1f} s  {:5.1f}x", words[static_cast<int>(result.kind)], result.cell_s,
                                 result.cpu_s > 0 ? result.cell_s / result.cpu_s : 0.0);
  if (!result.unsafe.empty()) line += "  UNSAFE";
  if (result.hung) line += "  HUNG";
  if (!result.why.empty()) line += "  " + result.why;
  return line;
}

}  // namespace pizarra::chaos
