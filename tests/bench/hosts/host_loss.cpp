#include "tests/bench/hosts/host_loss.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>
#include <stdexcept>

#include "blackboard/wire/keys.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/stopping.hpp"
#include "tests/run_task.hpp"
#include "tests/scratch.hpp"

namespace pizarra::bench {

namespace {

constexpr Duration between_notes = 100ms;
constexpr std::chrono::seconds goal_patience{180};
constexpr const char* coordinator_host = "board-pc";

Datum form(const char* text) { return read_one(text).value(); }

}  // namespace

HostLoss::HostLoss(std::uint64_t seed, std::function<bool()> is_stopped)
    : is_stopped_(std::move(is_stopped)), random_(seed), cell_(network::CellOnHosts::Boards::that_take_over) {
  cell_.network().enter("world-pc");
  cell_.up("world-pc");
  for (const std::string& host : network::CellOnHosts::hosts) cell_.up(host);
  if (!cell_.comes("world-pc", "ask '(person done ?what)'", "?what = ", std::chrono::seconds(240))) {
    throw std::runtime_error("the cell does not come to life:\n" + cell_.said());
  }
  begin();
}

HostLoss::~HostLoss() = default;

void HostLoss::begin() {
  const std::string keys = cell_.network().folder("world-pc") + "keys/world-pc.secret";
  const Result<wire::ClientKeys> key = wire::read_client_keys(keys);
  if (!key) throw std::runtime_error(describe(key.error()));
  board_ = client::RemoteBoard::connect(executor_, cell_.boards(), "bench", 5s, *key).value();
  world_ = std::make_unique<simulation::SocketLink>(executor_, context_,
                                                    "ipc://" + cell_.network().shared_folder() + "world.ipc");
  const std::vector<Relation> relations = {
      relation_from_datum(form("(relation note ((n integer)) (key n) (durable))")).value()};
  while (!run(executor_, board_->declare(relations))) continue;
  telling_ = executor_.spawn(tell_notes());
  watching_ = executor_.spawn(watch_operations());
}

// One after another while a round goes on; of one that was not answered it is not known whether it stands.
Task<void> HostLoss::tell_notes() {
  while (true) {
    co_await sleep(executor_, between_notes);
    if (!tells_) continue;
    const std::int64_t note = next_note_++;
    is_telling_ = true;
    const bool is_after_the_loss = no_tell_since_.has_value();
    const Result<Revision> told = co_await board_->tell(list("note"_sym, note));
    is_telling_ = false;
    if (told) acknowledged_.insert(note);
    if (told && is_after_the_loss) note_wait(no_tell_since_, waits_.told_s);
  }
}

Task<void> HostLoss::watch_operations() {
  Query operations = query_for(form("(operation ?index ?what ?state)"));
  while (true) {
    const Result<std::unique_ptr<Watch>> watch = co_await board_->watch(operations);
    if (!watch) {
      co_await sleep(executor_, between_notes);
      continue;
    }
    while (true) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      for (const Answer& answer : change->added) {
        const Fact& fact = answer.facts.front();
        // One that stands is shown again when the watch is resynchronised.
        if (seen_last_ == fact.id) continue;
        seen_last_ = fact.id;
        note_wait(no_work_since_, waits_.worked_s);
        const Datum& what = fact.datum[2];
        const bool is_done = fact.datum[3].is_symbol("done");
        if (is_done && what == done_last_) ++tally_.done_twice;
        if (is_done) done_last_ = what;
        // After another operation was begun, the same one may be needed again: a cube was laid down in between.
        if (what != done_last_) done_last_ = Datum();
      }
    }
  }
}

void HostLoss::pass(Duration time) {
  bool over = false;
  executor_.call_at(executor_.now() + time, [&] { over = true; });
  executor_.run_until([&] { return over || is_stopped_(); });
  if (is_stopped_()) throw Stopped();
}

Duration HostLoss::between(int least_ms, int most_ms) {
  return std::chrono::milliseconds(least_ms + static_cast<int>(random_.below(most_ms - least_ms + 1)));
}

bool HostLoss::lose_the_leading_host(programs::Running& asking) {
  std::string host = cell_.leading_host();
  for (int tries = 0; tries < 50 && host.empty(); ++tries) {
    pass(100ms);
    host = cell_.leading_host();
  }
  if (host.empty()) throw std::runtime_error("no board leads:\n" + cell_.said());
  last_ = host;
  const bool ended_before = asking.end(std::chrono::seconds(0)).has_value();
  cell_.network().cut_power(host);
  no_tell_since_ = no_work_since_ = executor_.now();
  pass(between(500, 4000));
  cell_.network().link(host, "both");
  cell_.up(host);
  return ended_before;
}

// It may have been on the host that was lost last.
void HostLoss::wait_for_the_coordinator() {
  const auto patience = std::chrono::steady_clock::now() + goal_patience;
  Result<std::vector<Fact>> there = fail("unavailable", "not asked yet");
  while (!there || there->empty()) {
    if (std::chrono::steady_clock::now() > patience) throw std::runtime_error("no coordinator comes:\n" + cell_.said());
    pass(100ms);
    there = run(executor_, board_->facts(form("(agent coordinator ? ?)")));
  }
}

void HostLoss::note_wait(std::optional<Time>& since, std::vector<double>& waits_s) const {
  if (since) waits_s.push_back(std::chrono::duration<double>(executor_.now() - *since).count());
  since.reset();
}

void HostLoss::round() {
  wait_for_the_coordinator();
  const bool even = tally_.rounds++ % 2 == 0;
  const std::string upper = even ? "circle" : "triangle";
  const std::string goal = fmt::format("(on {} {})", upper, even ? "triangle" : "circle");
  first_note_ = next_note_;
  tells_ = true;
  done_last_ = Datum();
  programs::Running asking(
      cell_.network().on("world-pc", {"/bin/sh", "-c", fmt::format("exec {} goal '{}'", PIZARRA_CELL, goal)}),
      scratch_folder() + "goal.log");
  pass(between(0, 10'000));
  const bool ended_before = lose_the_leading_host(asking);
  std::optional<int> status;
  const auto patience = std::chrono::steady_clock::now() + goal_patience;
  while (!status && std::chrono::steady_clock::now() < patience) {
    pass(200ms);
    status = asking.end(std::chrono::seconds(0));
  }
  tells_ = false;
  no_work_since_.reset();
  std::string said = asking.said();
  while (said.ends_with('\n')) said.pop_back();
  judge(upper, {.status = status.value_or(-1),
                .nobody_would_pursue = said.contains("nobody would pursue a goal"),
                .lost_the_coordinator = last_ == coordinator_host,
                .ended_before_the_loss = ended_before});
  last_ += ": " + goal + " " + said.substr(said.rfind('\n') + 1);
  if (!tally_.is_well()) last_ += newest_events();
}

std::string HostLoss::newest_events() {
  constexpr std::size_t most = 60;
  Result<std::vector<Fact>> events = run(executor_, board_->facts(form("(event ? ? ? ?)")));
  if (!events) return "\n  " + describe(events.error());
  std::ranges::sort(*events, {}, [](const Fact& fact) { return fact.datum[1].integer(); });
  std::string text;
  for (const Fact& event : std::span(*events).last(std::min(most, events->size()))) {
    text += fmt::format("\n  {} {}", event.datum[1].integer(), event.datum[3].text());
  }
  return text;
}

// By the world alone.
void HostLoss::judge(const std::string& upper, GoalEnd end) {
  pass(2s);
  const story::WorldState world = truth();
  end.cube_is_gone = std::ranges::any_of(world.cubes, [](const auto& cube) { return cube.second.gone; });
  const story::WorldState::Cube& cube = world.cubes.at(upper);
  const std::string lower = upper == "circle" ? "triangle" : "circle";
  end.world_has_it = cube.on == lower && !cube.held;
  const GoalVerdict verdict = verdict_of(end);
  if (verdict == GoalVerdict::reached) ++tally_.reached;
  if (verdict == GoalVerdict::refused_correctly) ++tally_.refused_correctly;
  if (verdict == GoalVerdict::failed) ++tally_.failed;
  tally_.durable_lost += lost_notes();
}

// And takes them away, so that one that comes back shows.
int HostLoss::lost_notes() {
  executor_.run_until([this] { return !is_telling_; });
  Result<std::vector<Fact>> standing = fail("unavailable", "");
  while (!standing) standing = run(executor_, board_->facts(form("(note ?)")));
  std::set<std::int64_t> there;
  for (const Fact& fact : *standing) there.insert(fact.datum[1].integer());
  int lost = 0;
  for (const std::int64_t note : acknowledged_) lost += there.contains(note) ? 0 : 1;
  for (const std::int64_t note : there) lost += note < first_note_ ? 1 : 0;
  Transaction removing;
  removing.retract(form("(note ?)"));
  while (!run(executor_, board_->transact(removing))) continue;
  acknowledged_.clear();
  return lost;
}

story::WorldState HostLoss::truth() {
  Result<story::WorldState> world = fail("disconnected", "");
  while (!world) world = run(executor_, story::read_world_state(*world_));
  return *world;
}

}  // namespace pizarra::bench
