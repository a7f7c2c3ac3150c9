#include "programs/chaos/fault_player.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "lisp/writer.hpp"
#include "programs/chaos/draw_camera.hpp"
#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

namespace {

constexpr Duration poll_pause = 20ms;
constexpr Duration busy_pause = 200ms;
constexpr Duration reset_timeout = 5s;
constexpr int most_tries = 100;
// The arm carries its mark before the camera, as soon as it is not held up.
constexpr Duration camera_is_found = 90s;

Duration seconds(double s) { return Duration(static_cast<Duration::rep>(std::llround(s * 1e6))); }
Duration seconds(const Datum& s) { return seconds(s.number()); }

std::string name_in(const Datum& what) { return std::string(what[1].text()); }
std::uint64_t steps_in(const Datum& number) { return static_cast<std::uint64_t>(number.integer()); }

bool is_one_of(const Datum& what, std::initializer_list<std::string_view> forms) {
  return std::ranges::any_of(forms, [&](std::string_view form) { return what.is_form(form); });
}

Datum camera_pose_on(const memory::MemoryBoard* board) {
  const std::vector<Datum> poses = facts_of(board, "(camera-pose ? ? ? ? ? ? ? ? ?)");
  return poses.empty() ? Datum() : poses.front();
}

// How long a fault disturbs by itself. Most forms say it in their last number. Hands and people tell when they are
// done. The rest is done at once.
Duration length_of(const Fault& fault) {
  const Datum& last = fault.what[fault.what.size() - 1];
  const bool at_once = fault.what.is_form("invented") || fault.kind == "clock" || fault.kind == "bump" ||
                       fault.kind == "misplace" || fault.kind == "hand" || !last.is_number();
  return at_once ? Duration::zero() : seconds(last);
}

}  // namespace

FaultPlayer::FaultPlayer(ChaosCell& cell, ChaosCell::Client& bystander, runtime::Caller& caller,
                         std::vector<Fault> faults, std::function<void(const std::string&)> tell)
    : cell_(cell),
      bystander_(bystander),
      caller_(caller),
      faults_(std::move(faults)),
      tell_(std::move(tell)),
      camera_(cell.description().world_camera) {}

FaultPlayer::~FaultPlayer() = default;

void FaultPlayer::begin() {
  if (is_camera_guessed(cell_.description())) camera_sought_since_ = cell_.time().now();
  for (const Fault& fault : faults_) waiting_.push_back(cell_.time().spawn(happen_in_time(fault)));
}

Task<void> FaultPlayer::end() {
  waiting_.clear();
  ending_ = true;
  disturbed_until_ = cell_.time().now();
  cell_.heal();
  const Datum steady = list("fingers"_sym, "misplace"_sym, 0.0);
  co_await ask_world(steady);
  bool acting = true;
  while (acting) {
    co_await sleep(cell_.time(), poll_pause);
    acting = hands_ > 0 || said_ > 0 || alarms_ > 0;
  }
}

Task<void> FaultPlayer::happen_in_time(const Fault& fault) {
  if (!fault.when.operation.empty()) co_await await_servo(fault.when);
  co_await sleep(cell_.time(), seconds(fault.when.after_s));
  happen(fault);
}

bool FaultPlayer::is_quiet() const {
  const bool nobody_acts = hands_ == 0 && said_ == 0 && alarms_ == 0;
  return cell_.time().now() > disturbed_until_ && nobody_acts && arm_answers() && !camera_is_sought();
}

bool FaultPlayer::arm_answers() const {
  const WorldProcess& world = cell_.world();
  return world.arm_answered_at >= world.arm_lost_at;
}

bool FaultPlayer::camera_is_sought() const {
  if (!camera_sought_since_ || cell_.time().now() > *camera_sought_since_ + camera_is_found) return false;
  const Datum told = camera_pose_on(cell_.board());
  return told == told_before_ || told == Datum() || !told[7].is_symbol("measured");
}

Task<void> FaultPlayer::await_servo(const Fault::When& when) {
  while (true) {
    const InHand now = in_hand(cell_.board());
    if (now.operation == when.operation && now.servo_state == when.servo_state) co_return;
    co_await sleep(cell_.time(), poll_pause);
  }
}

void FaultPlayer::happen(const Fault& fault) {
  ++happened_;
  disturbed_until_ = std::max(disturbed_until_, cell_.time().now() + length_of(fault));
  tell_(write(fault_to_datum(fault)));
  const Datum& what = fault.what;
  if (what.is_form("slip")) return acting_.push_back(cell_.time().spawn(let_slip()));
  count(fault.kind, in_hand(cell_.board()));
  if (fault.kind == "network" || fault.kind == "reply") return do_to_network(what);
  if (fault.kind == "disk") return do_to_disk(what);
  if (what.is_form("invented")) {
    return cell_.invent_sighting({.object = name_in(what),
                                  .beside = std::string(what[2].text()),
                                  .aside_px = what[3].number(),
                                  .looks_left = static_cast<int>(what[4].integer())});
  }
  if (fault.kind == "frames" || fault.kind == "sight" || fault.kind == "light") return do_to_camera(what);
  if (fault.kind == "bump") return bump_camera(what);
  if (fault.kind == "arm" || fault.kind == "pendant" || fault.kind == "sensor") return do_to_arm(what);
  if (fault.kind == "agent") return cell_.kill(name_in(what), seconds(what[3]), steps_in(what[2]));
  if (fault.kind == "pause") return cell_.pause(name_in(what), seconds(what[3]), steps_in(what[2]));
  if (fault.kind == "board") return cell_.kill_board(seconds(what[2]), what.is_form("power-cut"), steps_in(what[1]));
  if (fault.kind == "clock") return cell_.jump_clock(name_in(what), seconds(what[2]));
  if (what.is_form("stop")) {
    return acting_.push_back(cell_.time().spawn(say(list("stop"_sym, "bystander"_sym, "chaos"), seconds(what[1]))));
  }
  if (what.is_form("command")) {
    const Datum commander = list("commander"_sym, "robot"_sym, "bystander"_sym);
    return acting_.push_back(cell_.time().spawn(say(commander, seconds(what[1]))));
  }
  if (fault.kind == "alarm") return acting_.push_back(cell_.time().spawn(alarm_for(seconds(what[1]))));
  if (fault.kind == "swap") {
    return cell_.exchange_names(name_in(what), std::string(what[2].text()), seconds(what[3]));
  }
  if (what.is_form("borrow")) return acting_.push_back(cell_.time().spawn(borrow(what)));
  if (what.is_form("hand")) return acting_.push_back(cell_.time().spawn(move_hand(what)));
  assert(what.is_form("misplace") && "each fault that is drawn is played");
  acting_.push_back(cell_.time().spawn(ask_world(list("fingers"_sym, "misplace"_sym, what[1]))));
}

void FaultPlayer::count(const std::string& kind, const InHand& during) {
  if (!during.operation.empty()) coverage_.hit(pair_point(kind, during.operation, during.servo_state));
}

void FaultPlayer::do_to_network(const Datum& what) {
  simulated::Network& network = cell_.network();
  if (what.is_form("break")) return network.break_connections(name_in(what));
  if (what.is_form("stall")) return network.stall(name_in(what), seconds(what[2]));
  if (what.is_form("lose-reply")) return network.lose_next_reply(name_in(what));
  assert(what.is_form("delay") && "each fault of the network is played");
  network.set_delay({.least = 50us, .most = seconds(what[1])});
  cell_.time().call_at(cell_.time().now() + seconds(what[2]),
                       [this] { cell_.network().set_delay({.least = 50us, .most = 400us}); });
}

void FaultPlayer::do_to_disk(const Datum& what) {
  simulated::SimulatedDisk& disk = cell_.disk();
  const Duration length = seconds(what[what.size() - 1]);
  assert(is_one_of(what, {"full", "fails", "slow"}) && "each fault of the disk is played");
  if (what.is_form("full")) disk.set_capacity(disk.used());
  if (what.is_form("fails")) disk.fail(true);
  if (what.is_form("slow")) disk.set_flush_time(seconds(what[1]));
  cell_.time().call_at(cell_.time().now() + length, [this] {
    cell_.disk().fail(false);
    cell_.disk().set_capacity(simulated::SimulatedDisk::plenty);
    cell_.disk().set_flush_time({});
  });
}

void FaultPlayer::do_to_camera(const Datum& what) {
  DeviceFaults& faults = cell_.world().faults;
  const Time until = cell_.world().process.now() + seconds(what[what.size() - 1]);
  assert(is_one_of(what, {"dropped", "frozen", "doubled", "late", "light", "hidden", "jumps"}) &&
         "each fault of the camera is played");
  if (what.is_form("dropped")) faults.frames_dropped_until = until;
  if (what.is_form("frozen")) faults.frames_frozen_until = until;
  if (what.is_form("doubled")) faults.frames_doubled_until = until;
  if (what.is_form("late")) {
    faults.frames_late_until = until;
    faults.frame_delay = seconds(what[1]);
  }
  if (what.is_form("light")) {
    faults.light_until = until;
    faults.light = what[1].number();
  }
  if (what.is_form("hidden")) {
    faults.hidden_until = until;
    faults.hidden_at = what[1].number();
  }
  if (what.is_form("jumps")) {
    faults.jumps_until = until;
    faults.jump_px = static_cast<int>(what[1].integer());
  }
}

void FaultPlayer::bump_camera(const Datum& what) {
  camera_sought_since_ = cell_.time().now();
  told_before_ = camera_pose_on(cell_.board());
  if (what.is_form("nudge")) return request_from_world("head"_sym, what);
  for (std::size_t axis = 0; axis < 3; ++axis) camera_.at_mm[axis] += what[axis + 1].number();
  camera_.pan_deg += what[4].number();
  camera_.tilt_deg += what[5].number();
  camera_.roll_deg += what[6].number();
  request_from_world("camera"_sym, what);
}

void FaultPlayer::request_from_world(Datum device, const Datum& what) {
  std::vector<Datum> request{std::move(device)};
  request.insert(request.end(), what.items().begin(), what.items().end());
  acting_.push_back(cell_.time().spawn(ask_world(Datum::list(std::move(request)))));
}

void FaultPlayer::do_to_arm(const Datum& what) {
  DeviceFaults& faults = cell_.world().faults;
  const Datum stop = list("arm"_sym, "stop"_sym);
  if (what.is_form("stops-short")) return acting_.push_back(cell_.time().spawn(ask_world(stop)));
  const Time until = cell_.world().process.now() + seconds(what[what.size() - 1]);
  assert(is_one_of(what, {"away", "stuck", "acks-late", "acks-twice", "pendant"}) && "each fault of the arm is played");
  if (what.is_form("away")) faults.arm_away_until = until;
  if (what.is_form("stuck")) faults.sensor_stuck_until = until;
  if (what.is_form("acks-late")) {
    faults.acks_late_until = until;
    faults.ack_delay = seconds(what[1]);
  }
  if (what.is_form("acks-twice")) {
    faults.acks_twice_until = until;
    faults.second_ack_after = seconds(what[1]);
  }
  if (what.is_form("pendant")) {
    faults.pendant_until = until;
    acting_.push_back(cell_.time().spawn(ask_world(stop)));
  }
}

// It counts only where something was held.
Task<void> FaultPlayer::let_slip() {
  const InHand during = in_hand(cell_.board());
  const Datum slip = list("fingers"_sym, "slip"_sym);
  const Result<simulation::Message> slipped = co_await cell_.world().world->handle(slip);
  if (slipped) count("slip", during);
}

// The request may be impossible just then, as where nothing moves.
Task<void> FaultPlayer::ask_world(Datum request) {
  [[maybe_unused]] const Result<simulation::Message> done = co_await cell_.world().world->handle(std::move(request));
}

Task<void> FaultPlayer::move_hand(Datum request) {
  ++hands_;
  for (int tries = 0; tries < most_tries; ++tries) {
    const Result<simulation::Message> moved = co_await cell_.world().world->handle(request);
    const bool busy = !moved && moved.error().symbol == "busy";
    if (!busy) break;
    co_await sleep(cell_.time(), busy_pause);
  }
  hand_moved_ = cell_.time().now();
  --hands_;
}

Task<void> FaultPlayer::borrow(Datum what) {
  ++hands_;
  const Datum remove = list("hand"_sym, "remove"_sym, what[1]);
  co_await move_hand(remove);
  const Time until = cell_.time().now() + seconds(what[2]);
  while (cell_.time().now() < until) {
    if (ending_) break;
    co_await sleep(cell_.time(), poll_pause);
  }
  // Its mark stays: the word for it is not looked at.
  const Datum add = list("hand"_sym, "add"_sym, what[1], "circle", what[3], what[4]);
  co_await move_hand(add);
  --hands_;
}

Task<void> FaultPlayer::say(Datum fact, Duration length) {
  ++said_;
  Transaction telling;
  telling.tell(fact);
  const Result<Revision> told = co_await bystander_.board->transact(std::move(telling));
  if (told) co_await sleep(cell_.time(), length);
  // Whether it stands or not: who does not know says so until it is heard.
  while (true) {
    Transaction retracting;
    retracting.retract(fact);
    const Result<Revision> gone = co_await bystander_.board->transact(std::move(retracting));
    if (gone) break;
    co_await sleep(cell_.time(), busy_pause);
  }
  --said_;
}

Task<void> FaultPlayer::alarm_for(Duration length) {
  ++alarms_;
  bool& alarm = cell_.world().faults.alarm;
  alarm = true;
  const Datum stop = list("arm"_sym, "stop"_sym);
  co_await ask_world(stop);
  const Time until = cell_.time().now() + length;
  while (cell_.time().now() < until) {
    if (ending_) break;
    co_await sleep(cell_.time(), poll_pause);
  }
  // Another person may have reset it meanwhile.
  const Datum reset = list("get-control"_sym);
  while (alarm) {
    [[maybe_unused]] const Result<Datum> asked = co_await caller_.call("robot", reset, reset_timeout);
    co_await sleep(cell_.time(), busy_pause);
  }
  --alarms_;
}

}  // namespace pizarra::chaos
