#include "programs/chaos/observers.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/writer.hpp"
#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

namespace {

constexpr Duration look_pause = 50ms;
constexpr int looks_a_world_look = 5;
constexpr Duration lately = 3s;
// The robot agent ends what moves within 100 ms of a stop; the arm's brakes take a quarter of a second.
constexpr Duration stop_is_heard = 100ms;
constexpr Duration brakes_take = 250ms;
constexpr Duration look_slack = 60ms;

// Events that are points of the coverage, recognised by words of their sentence.
struct Telling {
  std::string_view kind;
  std::string_view words;
  const char* point;
};
constexpr Telling tellings[] = {
    {"servo", "laying down", "event lays-down"},
    {"servo", "room", "event makes-room"},
    {"servo", "lift", "event lifts-on-sight"},
    {"agent", "goes on", "event resumes-goal"},
    {"agent", "waiting for the robot", "event waits-for-robot"},
    {"agent", "asking it to track again", "event asks-eyes-again"},
    {"operation", "fail", "event operation-fails"},
    {"plan", "still serves", "event plan-kept"},
};

}  // namespace

Observers::Observers(ChaosCell& cell, const story::Judge& judge, Tell tell)
    : cell_(cell), judge_(judge), tell_(std::move(tell)) {
  cell_.world().on_request = [this](const std::string&, const Datum& request) { hear(request); };
}

Observers::~Observers() { cell_.world().on_request = nullptr; }

void Observers::begin() { looking_ = cell_.time().spawn(look()); }

void Observers::add_unsafe(std::string sentence) {
  tell_(cell_.time().now(), "unsafe", sentence);
  unsafe_.push_back(std::move(sentence));
}

void Observers::hear(const Datum& request) {
  if (!request.is_form("arm") || request.size() < 2) return;
  if (request[1].is_symbol("move")) note_motion();
  if (!request[1].is_symbol("stop")) return;
  std::erase_if(halts_, [](const Job& job) { return job.done(); });
  halts_.push_back(cell_.time().spawn(check_halt()));
}

void Observers::note_motion() {
  ++motions_;
  const Time now = cell_.time().now();
  const bool stopped = stop_stands_since_ && now - *stop_stands_since_ > stop_is_heard + look_slack;
  if (stopped && !facts_of(cell_.board(), "(stop ? ?)").empty()) {
    add_unsafe("a motion begins under a standing stop");
  }
  const std::vector<Datum> motions = facts_of(cell_.board(), "(robot-motion robot ? ?)");
  const bool known_of = std::ranges::any_of(motions, [](const Datum& motion) { return motion[3] == Datum(); });
  if (cell_.board() != nullptr && !known_of) add_unsafe("a motion begins that the board does not know of");
  if (motions.empty()) return;
  const int life = cell_.lives("robot");
  const auto [known, first] = moved_for_.emplace(motions.front()[2], life);
  if (!first && known->second != life) {
    add_unsafe(fmt::format("a motion is made again for the request {}", write(motions.front()[2])));
  }
}

// Asked of the simulated arm itself. One that moved as the stop came rests soon, and knows that it was stopped. Whoever
// then orders another motion has had it end.
Task<void> Observers::check_halt() {
  const std::uint64_t motions = motions_;
  const Datum question = list("arm"_sym, "read"_sym);
  const Result<simulation::Message> before = co_await cell_.world().world->handle(question);
  const bool moved = before && before->head[1].is_symbol("yes");
  if (!moved) co_return;
  co_await sleep(cell_.time(), stop_is_heard + brakes_take);
  const Result<simulation::Message> after = co_await cell_.world().world->handle(question);
  const bool tells = after && motions_ == motions;
  if (!tells) co_return;
  const bool heeded = after->head[1].is_symbol("no") && after->head[2].is_symbol("yes");
  if (!heeded) add_unsafe("the arm moves on after a stop came to its controller");
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
    check_marks();
  }
  const bool stop = !facts_of(board, "(stop ? ?)").empty();
  if (!stop) stop_stands_since_.reset();
  if (stop && !stop_stands_since_) stop_stands_since_ = cell_.time().now();
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
}

void Observers::note_event(const Datum& event) {
  last_event_ = event[1].integer();
  const std::string kind(event[2].text());
  const std::string_view sentence = event[3].text();
  tell_(cell_.time().now(), kind, std::string(sentence));
  coverage_.hit("event " + kind);
  for (const Telling& telling : tellings) {
    if (kind == telling.kind && sentence.find(telling.words) != std::string_view::npos) coverage_.hit(telling.point);
  }
}

// An agent that lives and is not present any more has lost its lease.
void Observers::look_at_presence() {
  for (const std::string& kind : cell_.kinds()) {
    const bool there = !facts_of(cell_.board(), list("agent"_sym, Datum::symbol(kind), "?"_sym, "?"_sym)).empty();
    const int life = cell_.lives(kind);
    const auto before = present_.find(kind);
    if (there) {
      if (before == present_.end() && life > 1) coverage_.hit("cell agent-lived-again");
      present_[kind] = life;
    } else if (before != present_.end()) {
      if (before->second == life) coverage_.hit("cell lease-lapsed");
      present_.erase(before);
    }
  }
}

void Observers::check_marks() {
  for (const std::int64_t mark : marks_) {
    if (!facts_of(cell_.board(), list("chaos-mark"_sym, mark)).empty()) continue;
    add_unsafe(fmt::format("the board lost mark {}, which it had said it keeps", mark));
  }
}

}  // namespace pizarra::chaos
