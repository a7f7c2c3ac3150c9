#include "agents/coordinator/act/arm.hpp"

#include <cmath>

#include "agents/coordinator/retried_commit.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::coordinator {

namespace {

// Longer than an agent that died may stay away, since a request it left is done by its successor.
constexpr Duration motion_timeout = 40s;
constexpr Duration stop_timeout = 10s;
constexpr Duration busy_pause = 200ms;
constexpr int busy_tries = 50;

}  // namespace

Task<Result<Datum>> Arm::ask(Datum operation) {
  for (int i = 0; i < busy_tries; ++i) {
    if (!roles_.holder("robot").is_present()) {
      const Datum robot = Datum::symbol(roles_.holder("robot").server);
      co_await story_.tell("agent", "waiting for the robot agent to come back", robot);
      const Time deadline = context_.executor.now() + options_.absence_patience;
      const bool back = co_await roles_.wait_for("robot", deadline);
      if (!back) co_return fail("absent", "the robot agent stays away", robot);
    }
    asked_ = caller_.next_id();
    const Result<Datum> done = co_await caller_.call(roles_.player("robot"), operation, motion_timeout, *asked_);
    asked_.reset();
    if (done) co_return done;
    // Another arm does not stand where this one was going.
    if (done.error().symbol == "replaced") co_return fail("stopped", done.error().sentence, operation);
    if (done.error().symbol != "busy") co_return done;
    co_await sleep(context_.executor, busy_pause);
  }
  co_return fail("busy", "the robot stays busy", operation);
}

Task<double> Arm::speed_percent() {
  const Datum pattern = list("robot-speed"_sym, Datum::symbol(roles_.holder("robot").server), "?"_sym);
  const std::vector<Fact> set = co_await facts_now(context_.board, context_.executor, pattern);
  co_return set.empty() ? 100 : set.front().datum[2].number();
}

Task<Result<void>> Arm::perform(ServoCommand command) {
  using Motion = ServoCommand::Motion;
  const double amount = std::abs(command.amount);
  const bool positive = command.amount >= 0;
  const Datum side = Datum::symbol(positive ? "right" : "left");
  const Datum back = Datum::symbol(positive ? "left" : "right");
  Datum operation;
  switch (command.motion) {
    case Motion::done:
      co_return Result<void>();
    case Motion::up:
      operation = list("move-v"_sym, "up"_sym, amount);
      break;
    case Motion::down:
      operation = list("move-v"_sym, "down"_sym, amount);
      break;
    case Motion::move_h:
      operation = list("move-h"_sym, side, amount);
      break;
    case Motion::turn:
      operation = list("turn"_sym, side, amount);
      break;
    case Motion::extend:
      operation = positive ? list("extend"_sym, "keep-height"_sym, amount) : list("retract"_sym, amount);
      break;
  }
  Result<Datum> done = co_await ask(operation);
  if (!done) co_return fail(done);
  const bool is_line = command.motion != Motion::turn && command.motion != Motion::extend;
  const bool at_limit = *done == list("false"_sym);
  if (is_line && at_limit) co_return fail("unreachable", "the arm goes no further this way", operation);
  if (command.motion != Motion::turn) co_return Result<void>();
  const Datum turned_back = list("turn-wrist"_sym, back, amount);
  done = co_await ask(turned_back);
  if (!done) co_return fail(done);
  co_return Result<void>();
}

Task<Result<void>> Arm::cut_short() {
  if (!asked_) co_return Result<void>();
  const Datum operation = list("finish"_sym, "stop"_sym, *asked_);
  const Result<Datum> stopped = co_await caller_.call(roles_.player("robot"), operation, stop_timeout);
  if (!stopped) co_return fail(stopped);
  co_return Result<void>();
}

Task<Result<void>> Arm::move_to(Eigen::Vector3d point_mm) {
  const Datum operation =
      list("move-to"_sym, rounded(point_mm.x(), 100), rounded(point_mm.y(), 100), rounded(point_mm.z(), 100));
  const Result<Datum> moved = co_await ask(operation);
  if (!moved) co_return fail(moved);
  co_return Result<void>();
}

Task<Result<Eigen::Vector3d>> Arm::grip_centre() {
  const Datum monitor = list("monitor"_sym);
  const Result<Datum> reading = co_await ask(monitor);
  if (!reading) co_return fail(reading);
  if (reading->size() < 3) co_return fail("bad-reply", "the robot's monitor gives no position", *reading);
  co_return Eigen::Vector3d((*reading)[0].number(), (*reading)[1].number(), (*reading)[2].number());
}

Task<Result<void>> Arm::face(double yaw_deg) {
  constexpr double good_enough_deg = 0.5;
  const Datum monitor = list("monitor"_sym);
  const Result<Datum> reading = co_await ask(monitor);
  if (!reading) co_return fail(reading);
  if (reading->size() < 6) co_return fail("bad-reply", "the robot's monitor gives no pose", *reading);
  const double missing = std::remainder(yaw_deg - (*reading)[5].number(), 360);
  if (std::abs(missing) < good_enough_deg) co_return Result<void>();
  const Datum side = Datum::symbol(missing > 0 ? "right" : "left");
  const Datum operation = list("turn-wrist"_sym, side, std::abs(missing));
  const Result<Datum> turned = co_await ask(operation);
  if (!turned) co_return fail(turned);
  co_return Result<void>();
}

Task<Result<double>> Arm::grip(double opening_mm) {
  const Datum operation = list("gripper"_sym, opening_mm);
  const Result<Datum> done = co_await ask(operation);
  if (!done) co_return fail(done);
  // The robot tells the opening before it answers.
  const Datum pattern = list("gripper"_sym, Datum::symbol(roles_.holder("robot").server), "?opening"_sym);
  const std::vector<Fact> told = co_await facts_now(context_.board, context_.executor, pattern);
  if (told.empty()) co_return fail("bad-reply", "the robot told no opening of its gripper", operation);
  co_return told.back().datum[2].number();
}

bool was_cut_short(const Failure& why) { return why.symbol == "stopped" && why.subject.is_form("finish"); }

bool met_silence(const Failure& why) { return why.symbol == "stopped" && why.subject.is_form("silent"); }

bool is_beyond_reach(const Failure& why) { return why.symbol == "unreachable" || why.symbol == "joint-limit"; }

}  // namespace pizarra::coordinator
