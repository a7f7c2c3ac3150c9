#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/arm/route.hpp"
#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

Result<void> ArmCabinet::obey(std::string_view words) {
  const std::size_t blank = words.find(' ');
  const std::string_view what = words.substr(0, blank);
  const std::string_view how = blank == std::string_view::npos ? "" : words.substr(blank + 1);
  if (how == "on" || how == "off") return turn(what, how == "on");
  constexpr int highest_alarm = 9999;
  if (const auto code = number_from(how, 0, highest_alarm); code && what == "alarm") {
    if (*code != 0) raise(*code);
    alarm_ = *code;
    return {};
  }
  if (const auto percent = number_from(how, 1, 100); percent && what == "override") {
    override_ = *percent / 100.0;
    return {};
  }
  return fail("unknown-command",
              "nobody here understands '" + std::string(words) +
                  "': power, estop, pendant, hold or servo with on or off; alarm CODE; override PERCENT; "
                  "status");
}

Result<void> ArmCabinet::turn(std::string_view what, bool on) {
  if (what == "power") {
    power(on);
  } else if (what == "estop") {
    emergency_ = on;
    if (on) switch_servos_off();
  } else if (what == "pendant") {
    pendant_ = on;
  } else if (what == "hold") {
    pendant_hold_ = on;
  } else if (what == "servo") {
    if (servo(on) != Refusal::none) return fail("refused", "the servos cannot be switched on now");
    return {};
  } else {
    return fail("unknown-command",
                "there is no switch '" + std::string(what) + "': power, estop, pendant, hold, servo");
  }
  if (on && what != "power") brake();
  return {};
}

void ArmCabinet::power(bool on) {
  if (on == powered_) return;
  powered_ = on;
  if (!on) worked_.power += executor_.now() - power_since_;
  power_since_ = executor_.now();
  switch_servos_off();
  command_hold_ = false;
  if (on) {
    alarm_ = lost_in_motion_ ? power_lost_alarm : 0;
    if (alarm_ != 0) remember(alarm_);
    lost_in_motion_ = false;
    return;
  }
  brake();
}

void ArmCabinet::switch_servos_off() {
  if (servo_since_) worked_.servo += executor_.now() - *servo_since_;
  servo_since_.reset();
}

ArmCabinet::WorkTimes ArmCabinet::work_times() const {
  WorkTimes times = worked_;
  if (powered_) times.power += executor_.now() - power_since_;
  if (servo_since_) times.servo += executor_.now() - *servo_since_;
  return times;
}

void ArmCabinet::remember(int alarm) {
  constexpr std::size_t most = 100;
  past_alarms_.push_back(alarm);
  if (past_alarms_.size() > most) past_alarms_.pop_front();
}

void ArmCabinet::raise(int alarm) {
  alarm_ = alarm;
  remember(alarm);
  switch_servos_off();
  brake();
}

void ArmCabinet::brake() { braking_ = executor_.spawn(brake_and_look()); }

Task<void> ArmCabinet::brake_and_look() {
  const Result<arm::ArmReading> reading = co_await body_.read();
  const bool moves = reading && reading->moving;
  if (moves && !powered_) lost_in_motion_ = true;
  // One that cannot be reached is noticed when it is read.
  [[maybe_unused]] const Result<void> stopped = co_await body_.stop();
}

Refusal ArmCabinet::refusal() const {
  if (pendant_) return Refusal::pendant;
  if (alarm_ != 0) return Refusal::alarm;
  if (emergency_) return Refusal::emergency;
  if (!servo()) return Refusal::servo_off;
  if (pendant_hold_) return Refusal::pendant_hold;
  if (command_hold_) return Refusal::command_hold;
  return Refusal::none;
}

Task<Refusal> ArmCabinet::move(std::vector<arm::Joints> waypoints, double speed) {
  const Refusal why = refusal();
  if (why != Refusal::none) co_return why;
  for (const arm::Joints& joints : waypoints) {
    if (!arm::check_limits(model_, joints)) co_return Refusal::out_of_range;
  }
  const bool sound = !waypoints.empty() && speed > 0;
  if (!sound) co_return Refusal::out_of_range;
  const arm::ArmReading before = co_await read();
  if (before.moving) co_return Refusal::running;
  const arm::Joints target = waypoints.back();
  const double part = std::min(1.0, speed * override_);
  Result<void> started = co_await body_.start_move(waypoints, part);
  if (!started && started.error().symbol == "not-in-control") {
    const Result<void> control = co_await body_.take_control();
    if (control) started = co_await body_.start_move(std::move(waypoints), part);
  }
  if (!started) {
    if (started.error().symbol == "busy") co_return Refusal::running;
    raise(arm_lost_alarm);
    co_return Refusal::alarm;
  }
  // What came meanwhile found nothing to stop.
  if (refusal() != Refusal::none) brake();
  constexpr double nowhere_else = 1e-3;
  if (arm::are_same_place(target, before.joints, nowhere_else)) co_return Refusal::none;
  ++moves_;
  last_target_ = target;
  co_return Refusal::none;
}

Task<void> ArmCabinet::stop() {
  const Result<void> stopped = co_await body_.stop();
  if (!stopped) raise(arm_lost_alarm);
}

Refusal ArmCabinet::servo(bool on) {
  if (!on) {
    switch_servos_off();
    brake();
    return Refusal::none;
  }
  if (pendant_) return Refusal::pendant;
  if (emergency_) return Refusal::emergency;
  if (alarm_ != 0) return Refusal::alarm;
  if (!servo_since_) servo_since_ = executor_.now();
  return Refusal::none;
}

Refusal ArmCabinet::hold(bool on) {
  if (pendant_) return Refusal::pendant;
  command_hold_ = on;
  if (on) brake();
  return Refusal::none;
}

Refusal ArmCabinet::reset() {
  if (pendant_) return Refusal::pendant;
  alarm_ = 0;
  return Refusal::none;
}

Task<Refusal> ArmCabinet::grip(double opening_mm) {
  const Refusal why = refusal();
  if (why != Refusal::none) co_return why;
  Result<void> started = co_await body_.start_gripper(opening_mm);
  if (!started && started.error().symbol == "not-in-control") {
    const Result<void> control = co_await body_.take_control();
    if (control) started = co_await body_.start_gripper(opening_mm);
  }
  if (started) co_return Refusal::none;
  raise(arm_lost_alarm);
  co_return Refusal::alarm;
}

Task<arm::ArmReading> ArmCabinet::read() {
  const Result<arm::ArmReading> reading = co_await body_.read();
  constexpr Duration longest_look_away = 1s;
  if (last_.moving) worked_.motion += std::min<Duration>(executor_.now() - seen_at_, longest_look_away);
  seen_at_ = executor_.now();
  if (reading) {
    last_ = *reading;
  } else {
    last_.moving = false;
    if (alarm_ == 0) raise(arm_lost_alarm);
  }
  co_return last_;
}

}  // namespace pizarra::simulation
