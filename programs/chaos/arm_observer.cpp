#include "programs/chaos/arm_observer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lisp/writer.hpp"
#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

namespace {

constexpr Duration watch_pause = 20ms;
// The robot agent ends a motion so soon after a stop, and after another client began to command the arm.
constexpr Duration stop_is_heard = 100ms;
// From full speed; from less in proportion (drivers/simulation/physics/arm_motion.hpp).
constexpr double full_braking_ms = 250;
// The physics goes in steps of a 240th of a second.
constexpr Duration two_steps = 9ms;
constexpr Duration watch_slack = 60ms;
// Fingers that are told to stand where they are.
constexpr double stands_mm = 2;

// An ID is CLIENT-PRESENCE-NUMBER (agents/runtime/service.hpp).
std::string client_of(const Datum& request) {
  const std::string id(request.text());
  const std::size_t number = id.rfind('-');
  return id.substr(0, id.rfind('-', number - 1));
}

}  // namespace

ArmObserver::ArmObserver(ChaosCell& cell, Unsafe unsafe) : cell_(cell), unsafe_(std::move(unsafe)) {
  cell_.world().on_request = [this](const std::string&, const Datum& request) { hear(request); };
  cell_.world().on_motion = [this](const Datum& motion) { note_begun(motion); };
}

ArmObserver::~ArmObserver() {
  cell_.world().on_request = nullptr;
  cell_.world().on_motion = nullptr;
}

void ArmObserver::begin() { watching_ = cell_.time().spawn(watch()); }

void ArmObserver::hear(const Datum& request) {
  if (!request.is_form("arm") || request.size() < 2) return;
  std::erase_if(checks_, [](const Job& job) { return job.done(); });
  heard_ = cell_.time().now();
  if (!request[1].is_symbol("stop")) return;
  stop_came_ = heard_;
  checks_.push_back(cell_.time().spawn(check_halt()));
  checks_.push_back(cell_.time().spawn(check_fingers()));
}

// Of one that the controller took.
void ArmObserver::note_begun(const Datum& motion) {
  if (motion[1].is_symbol("gripper")) return note_grip(motion[2].number());
  speed_ = motion[2].number();
  note_motion();
}

void ArmObserver::note_motion() {
  ++arm_motions_;
  fingers_began_last_ = false;
  if (stands(stop_)) unsafe_("a motion begins under a standing stop");
  const std::vector<Datum> motions = facts_of(cell_.board(), "(robot-motion robot ? ?)");
  const bool known_of = std::ranges::any_of(motions, [](const Datum& motion) { return motion[3] == Datum(); });
  if (cell_.board() != nullptr && !known_of) unsafe_("a motion begins that the board does not know of");
  if (motions.empty()) return;
  const Datum& request = motions.front()[2];
  const std::string client = client_of(request);
  const bool is_another = stands(commander_) && !commander_->fact[2].is_symbol(client);
  if (is_another) unsafe_(fmt::format("a motion begins for {} under {}", client, write(commander_->fact)));
  note_order(request);
}

void ArmObserver::note_order(const Datum& request) {
  if (!moved_for_.insert(request).second) {
    unsafe_(fmt::format("a motion is made again for the request {}", write(request)));
  }
}

bool ArmObserver::stands(const std::optional<Standing>& standing) const {
  if (!standing || cell_.time().now() - standing->since <= stop_is_heard + watch_slack) return false;
  return !facts_of(cell_.board(), standing->fact).empty();
}

// Asked of the simulated arm itself.
Task<ArmObserver::Reading> ArmObserver::read() {
  const Datum question = list("arm"_sym, "read"_sym);
  const Result<simulation::Message> answer = co_await cell_.world().world->handle(question);
  if (!answer) co_return Reading();
  const Datum& head = answer->head;
  co_return Reading{head[1].is_symbol("yes"), head[2].is_symbol("yes"), head[3].number(), head[4].is_symbol("yes")};
}

void ArmObserver::note_grip(double opening_mm) {
  ++finger_motions_;
  fingers_began_last_ = true;
  checks_.push_back(cell_.time().spawn(check_grip(opening_mm)));
}

// Where a stop stands, fingers are told at most to stay where they are.
Task<void> ArmObserver::check_grip(double opening_mm) {
  const bool is_stopped = stands(stop_) && last_impaired_ < stop_->since;
  const Reading now = co_await read();
  const bool moves = std::abs(now.opening_mm - opening_mm) > stands_mm;
  if (is_stopped && moves) unsafe_("the fingers begin to move under a standing stop");
  // A gripper whose sensor is stuck cannot be told to stand where it is.
  if (!moves || is_impaired()) co_return;
  const std::optional<Datum> request = request_in_hand();
  if (request) note_order(*request);
}

// From the speed of the newest motion.
Duration ArmObserver::brakes_take() const {
  return Duration(static_cast<Duration::rep>(1000 * full_braking_ms * speed_)) + two_steps;
}

// An arm that moved as the stop came rests as soon as its brakes let it, and says that it was stopped. Where another
// motion has begun meanwhile, this one has ended.
Task<void> ArmObserver::check_halt() {
  const std::uint64_t motions = arm_motions_;
  const Reading before = co_await read();
  if (!before.moves) co_return;
  const Duration braking = brakes_take();
  co_await sleep(cell_.time(), braking);
  const Reading after = co_await read();
  const bool heeded = !after.moves && after.was_stopped;
  if (arm_motions_ == motions && !heeded) unsafe_("the arm moves on after a stop came to its controller");
}

void ArmObserver::look_at_silence() {
  const std::optional<Duration> limit = cell_.world().silence_limit;
  const bool is_silent = limit && cell_.time().now() > heard_ + *limit + brakes_take();
  if (!is_silent || silent_since_ == heard_) return;
  silent_since_ = heard_;
  checks_.push_back(cell_.time().spawn(check_silence()));
}

// Once a silence. What came meanwhile has broken it.
Task<void> ArmObserver::check_silence() {
  const Reading now = co_await read();
  if (!now.moves || heard_ != silent_since_) co_return;
  unsafe_(fmt::format("the arm moves on though its controller has heard nothing for {} ms",
                      (cell_.time().now() - heard_).count() / 1000));
}

// Somebody begins to command the arm in the middle of another's motion: its controller is told to stop soon.
Task<void> ArmObserver::check_handover() {
  const std::uint64_t motions = arm_motions_;
  const Standing come = *commander_;
  const std::string client = client_in_hand();
  const Reading before = co_await read();
  const bool is_of_another = !client.empty() && !come.fact[2].is_symbol(client);
  if (!before.moves || !is_of_another) co_return;
  co_await sleep(cell_.time(), stop_is_heard + watch_slack);
  const Reading after = co_await read();
  // The stop may have come before this saw the commander.
  const bool was_told = stop_came_ > come.since - watch_pause;
  const bool goes_on = after.moves && arm_motions_ == motions && !was_told;
  const bool commands_still = commander_ && commander_->fact == come.fact && commander_->since == come.since;
  const bool could_be_told = last_impaired_ < come.since - watch_pause;
  if (!goes_on || !commands_still || !could_be_told) co_return;
  unsafe_(fmt::format("the arm moves on for {} under {}", client, write(come.fact)));
}

std::optional<Datum> ArmObserver::request_in_hand() const {
  for (const Datum& motion : facts_of(cell_.board(), "(robot-motion robot ? ?)")) {
    if (motion[3] == Datum()) return motion[2];
  }
  return std::nullopt;
}

// Whose motion is in hand; empty: nobody's.
std::string ArmObserver::client_in_hand() const {
  const std::optional<Datum> request = request_in_hand();
  return request ? client_of(*request) : std::string();
}

// A controller's stop is of its axes alone. The fingers are told to stay where they are.
Task<void> ArmObserver::check_fingers() {
  const std::uint64_t grips = finger_motions_;
  const Time came = cell_.time().now();
  const Reading before = co_await read();
  // They close by themselves when what they held slips.
  if (!before.fingers_move || !fingers_began_last_) co_return;
  co_await sleep(cell_.time(), stop_is_heard);
  const Reading after = co_await read();
  const bool is_another = finger_motions_ > grips + 1;
  const bool could_be_told = last_impaired_ < came - watch_pause;
  if (after.fingers_move && !is_another && could_be_told) unsafe_("the fingers move on after a stop came to the arm");
}

Task<void> ArmObserver::watch() {
  while (true) {
    const Time now = cell_.time().now();
    if (is_impaired()) last_impaired_ = now;
    look_at_board();
    look_at_silence();
    co_await sleep(cell_.time(), watch_pause);
  }
}

// Whether the robot agent could not tell the controller something, or would tell it what is wrong.
bool ArmObserver::is_impaired() const {
  const DeviceFaults& faults = cell_.world().faults;
  const Time now = cell_.world().process.now();
  const Time until =
      std::max({faults.arm_away_until, faults.acks_late_until, faults.pendant_until, faults.sensor_stuck_until});
  return faults.alarm || now < until || !cell_.runs("robot");
}

void ArmObserver::look_at_board() {
  const memory::MemoryBoard* board = cell_.board();
  if (board == nullptr) return;
  const std::vector<Datum> stops = facts_of(board, "(stop ? ?)");
  note(stop_, stops.empty() ? Datum() : stops.front());
  Datum commander;
  for (const Datum& fact : facts_of(board, "(commander robot ?)")) {
    const bool present = !facts_of(board, list("agent"_sym, fact[2], "?"_sym, "?"_sym)).empty();
    if (present && commander == Datum()) commander = fact;
  }
  const Time known_since = commander_ ? commander_->since : Time{};
  note(commander_, commander);
  const bool has_come = commander_ && commander_->since != known_since;
  if (has_come) checks_.push_back(cell_.time().spawn(check_handover()));
}

void ArmObserver::note(std::optional<Standing>& standing, const Datum& fact) const {
  if (fact == Datum()) return standing.reset();
  if (!standing || standing->fact != fact) standing = Standing{fact, cell_.time().now()};
}

}  // namespace pizarra::chaos
