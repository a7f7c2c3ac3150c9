#include "agents/robot/arm_connection.hpp"

#include <fmt/format.h>

#include "drivers/arm/meeting.hpp"

namespace pizarra::robot {

Task<Result<arm::ArmReading>> ArmConnection::find() {
  const Result<arm::ArmMeeting> met = co_await arm::meet_arm(executor_, driver_, model_);
  if (!met) co_return fail(met);
  if (met->was_stopped) found_moving_ = true;
  facts_.set_reading(model_, met->reading);
  co_return met->reading;
}

Task<Result<void>> ArmConnection::connect() {
  const Result<arm::ArmReading> found = co_await find();
  if (!found) co_return fail(found);
  const bool in_trouble = found->trouble && found->trouble->kind != arm::ArmTrouble::Kind::off;
  if (!known_ && !in_trouble && released_by_.empty()) {
    const Result<void> on = co_await switch_on();
    if (!on) co_return on;
  }
  known_ = true;
  if (found_moving_) {
    facts_.set_arm("stopped", "STOPPED_AT_RESTART");
  } else if (!released_by_.empty()) {
    facts_.set_arm("stopped", "(release-control)");
  } else {
    facts_.set_arm("idle");
  }
  found_moving_ = false;
  there_ = true;
  co_return {};
}

// One that gives no control is monitored all the same.
Task<Result<void>> ArmConnection::switch_on() {
  const Result<void> control = co_await driver_.power_up();
  if (!control && control.error().symbol != "not-in-control") co_return control;
  const Result<arm::ArmReading> reading = co_await driver_.read();
  if (!reading) co_return fail(reading);
  facts_.set_reading(model_, *reading);
  co_return Result<void>();
}

Task<Result<void>> ArmConnection::get_control() {
  const Result<void> control = co_await driver_.take_control();
  if (!control) co_return control;
  const Result<arm::ArmReading> reading = co_await read();
  if (!reading) co_return fail(reading);
  facts_.set_arm("idle");
  released_by_.clear();
  co_return Result<void>();
}

Task<Result<void>> ArmConnection::release_control() {
  facts_.set_arm("stopped", "(release-control)");
  Result<void> released = co_await driver_.release_control();
  co_return released;
}

void ArmConnection::lose(const Failure& why) {
  there_ = false;
  why_lost_ = fmt::format("the arm cannot be commanded: {}", why.sentence);
  facts_.forget_reading();
  facts_.set_trouble(arm::ArmTrouble{arm::ArmTrouble::Kind::fault, {why.symbol, why_lost_, why.subject, {}}});
  facts_.set_arm("fault");
}

Task<Result<void>> ArmConnection::brake() {
  braked_at_ = executor_.now();
  return driver_.stop();
}

Task<Result<arm::ArmReading>> ArmConnection::read() {
  if (!known_) co_return fail("disconnected", why_lost_);
  const Result<arm::ArmReading> reading = co_await driver_.read();
  if (reading) facts_.set_reading(model_, *reading);
  if (reading) on_reading(*reading);
  co_return reading;
}

}  // namespace pizarra::robot
