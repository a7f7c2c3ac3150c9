#include "programs/chaos/observers.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

namespace {

constexpr Duration look_pause = 50ms;
constexpr int looks_a_world_look = 5;
constexpr Duration lately = 3s;
// Of eyes that track something: ten a second are usual. Eyes that came to life, or whose board did, are asked to track
// again before they tell looks.
constexpr Duration looks_come_within = 400ms;

// Events that are points of the coverage, recognised by words of their sentence.
struct Telling {
  std::string_view kind;
  std::string_view words;
  const char* point;
};
constexpr Telling tellings[] = {
    {"servo", "laying down", "event lays-down"},
    {"servo", "too close to its neighbour", "event makes-room"},
    {"servo", "aside, to see what it hides", "event sets-aside"},
    {"servo", "sweeping at the border", "event sweeps-border"},
    {"servo", "cannot be grasped as it lies", "event pushes"},
    {"servo", "finding out where the camera", "event surveys-camera"},
    {"servo", "the rescue failed", "event rescue-fails"},
    {"servo", "the motion towards it is cut short", "event cuts-motion-short"},
    {"servo", "moved during the approach", "event follows-object"},
    {"agent", "going on with goal", "event resumes-goal"},
    {"agent", "waiting for the robot", "event waits-for-robot"},
    {"agent", "asking it to track again", "event asks-eyes-again"},
    {"operation", "fail", "event operation-fails"},
    {"agent", "somebody holds", "event waits-for-hand"},
    {"agent", "held up", "event held-up"},
    {"plan", "still serves", "event plan-kept"},
    {"plan", "new plan", "event plans-anew"},
};

// Of a fact that did not hold, or of an operation that somebody else did.
std::string difference_point(const Datum& what) {
  const Datum& form = what.is_form("not") ? what[1] : what;
  return fmt::format("difference {}", form.head());
}

Eigen::Vector3d camera_mm(const ChaosCell& cell) {
  const std::array<double, 3>& at = cell.description().world_camera.at_mm;
  return {at[0], at[1], at[2]};
}

}  // namespace

Observers::Observers(ChaosCell& cell, const story::Judge& judge, Tell tell, std::function<bool()> is_quiet)
    : cell_(cell),
      judge_(judge),
      tell_(std::move(tell)),
      is_quiet_(std::move(is_quiet)),
      kept_(cell, [this](std::string sentence) { add_unsafe(std::move(sentence)); }),
      arm_(cell, [this](std::string sentence) { add_unsafe(std::move(sentence)); }),
      beliefs_(camera_mm(cell), judge, [this](std::string sentence) { add_unsafe(std::move(sentence)); }) {}

void Observers::begin() {
  arm_.begin();
  looking_ = cell_.time().spawn(look());
}

void Observers::add_unsafe(std::string sentence) {
  tell_(cell_.time().now(), "unsafe", sentence);
  unsafe_.push_back(std::move(sentence));
}

Task<void> Observers::look() {
  int looks = 0;
  while (true) {
    look_at_board();
    if (looks++ % looks_a_world_look == 0) co_await look_at_world();
    co_await sleep(cell_.time(), look_pause);
  }
}

Task<void> Observers::look_at_world() {
  const Datum question = list("truth"_sym);
  const Result<simulation::Message> answer = co_await cell_.world().world->handle(question);
  if (!answer) co_return;
  const Result<story::WorldState> truth = story::world_state_from_datum(answer->head);
  if (!truth) co_return;
  newest_ = *truth;
  const std::optional<std::string> news = world_news_.of(newest_);
  if (news) tell_(cell_.time().now(), "world", *news);
  const Result<std::vector<Datum>> facts = judge_.facts(newest_);
  const Time now = cell_.time().now();
  if (facts) lately_.push_back({now, *facts});
  while (!lately_.empty() && lately_.front().when < now - lately) lately_.pop_front();
  const Datum arm_question = list("arm"_sym, "read"_sym);
  const Result<simulation::Message> arm = co_await cell_.world().world->handle(arm_question);
  if (arm) look_at_beliefs(arm->head[3].number());
}

void Observers::look_at_beliefs(double opening_mm) {
  const Time now = cell_.time().now();
  const std::vector<Datum> looks = facts_of(cell_.board(), "(look ? ? ? ?)");
  if (looks != looks_) looked_ = now;
  looks_ = looks;
  const bool is_looked_at = !looks.empty() && now - looked_ < looks_come_within;
  beliefs_.look({.now = now,
                 .quiet = is_looked_at && are_all_present() && is_quiet_(),
                 .world = &newest_,
                 .opening_mm = opening_mm,
                 .told = told_on(cell_.board())});
}

bool Observers::are_all_present() const {
  const auto is_present = [&](const std::string& kind) {
    return cell_.runs(kind) && present_.is_present(kind, cell_.lives(kind));
  };
  return cell_.runs(simulated::BoardProcess::name) && std::ranges::all_of(cell_.kinds(), is_present);
}

bool Observers::showed_lately(const std::vector<Datum>& goal) const {
  return std::ranges::any_of(lately_, [&](const Moment& moment) { return story::Judge::holds(goal, moment.facts); });
}

void Observers::look_at_board() {
  const memory::MemoryBoard* board = cell_.board();
  if (board == nullptr) return;
  if (cell_.board_lives() != board_lives_) {
    board_lives_ = cell_.board_lives();
    coverage_.hit("cell board-lived-again");
    kept_.check_marks();
  }
  std::vector<Datum> events = facts_of(board, "(event ? ? ? ?)");
  std::ranges::sort(events, {}, [](const Datum& event) { return event[1].integer(); });
  for (const Datum& event : events) {
    if (event[1].integer() > last_event_) note_event(event);
  }
  const std::vector<Datum> arm = facts_of(board, "(arm robot stopped ?)");
  const std::string action = arm.empty() ? std::string() : std::string(arm.front()[3].text());
  // An order that it was given is no reason of its own.
  const bool is_reason = !action.empty() && !action.starts_with('(');
  if (action != arm_action_ && is_reason) coverage_.hit("arm " + action);
  arm_action_ = action;
  look_at_presence();
  kept_.look();
}

void Observers::note_event(const Datum& event) {
  last_event_ = event[1].integer();
  const std::string kind(event[2].text());
  const std::string_view sentence = event[3].text();
  tell_(cell_.time().now(), kind, std::string(sentence));
  coverage_.hit("event " + kind);
  const Datum& detail = event[4];
  if (detail.is_form("fail")) coverage_.hit(fmt::format("failure {}", detail[1].text()));
  if (kind == "difference") {
    for (const Datum& what : detail.items()) coverage_.hit(difference_point(what));
  }
  for (const Telling& telling : tellings) {
    if (kind == telling.kind && sentence.find(telling.words) != std::string_view::npos) coverage_.hit(telling.point);
  }
}

// An agent that lives and is not present any more has lost its lease.
void Observers::look_at_presence() {
  using Change = PresentAgents::Change;
  for (const std::string& kind : cell_.kinds()) {
    const int life = cell_.lives(kind);
    const bool was_present = present_.is_present(kind, life);
    const Datum pattern = list("agent"_sym, Datum::symbol(kind), "?"_sym, "?"_sym);
    const Change change = present_.look(kind, life, fact_id_of(cell_.board(), pattern));
    if (change == Change::came && life > 1) coverage_.hit("cell agent-lived-again");
    if (change == Change::went && was_present && cell_.runs(kind)) coverage_.hit("cell lease-lapsed");
  }
}

}  // namespace pizarra::chaos
