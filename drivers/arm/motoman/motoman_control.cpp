#include "drivers/arm/motoman/motoman_control.hpp"

#include <fmt/format.h>

namespace pizarra::arm {

namespace {

constexpr Duration servo_time = 3s;  // at most, until the servos are on
constexpr Duration look_again = 50ms;

bool is_locked(const MotomanStatus& status) { return status.teaching || !status.remote; }

bool is_held(const MotomanStatus& status) { return status.pendant_hold || status.external_hold; }

bool has_alarm(const MotomanStatus& status) { return status.alarm || status.error; }

}  // namespace

bool may_move(const MotomanStatus& status) {
  return status.servo && !is_locked(status) && !has_alarm(status) && !is_held(status);
}

std::unexpected<Failure> lost(const Failure& why) {
  if (why.symbol == "no-answer") return fail("disconnected", why.sentence, why.subject);
  return fail(why);
}

Task<Failure> MotomanControl::why_not(MotomanStatus status) {
  std::string sentence = "the controller has ended the motion";
  Datum subject;
  if (has_alarm(status)) {
    const Result<std::uint32_t> code = co_await link_.alarm_code();
    sentence = code ? fmt::format("the controller has alarm {}", *code) : "the controller has an alarm";
    if (code) subject = to_datum(*code);
  } else if (is_locked(status)) {
    sentence = "the pendant has control";
  } else if (!status.servo) {
    sentence = "the controller's servos are off, as by its emergency stop, which it does not tell apart";
  } else if (is_held(status)) {
    sentence = status.pendant_hold ? "the pendant holds the arm" : "a hold input holds the arm";
  }
  Failure why{"not-in-control", std::move(sentence), std::move(subject), {}};
  co_return why;
}

// An alarm's code is asked for once.
Task<void> MotomanControl::look(MotomanStatus status) {
  using Kind = ArmTrouble::Kind;
  const bool stopped = is_locked(status) || is_held(status);
  const bool fault = has_alarm(status);
  const bool known = fault && trouble_ && trouble_->kind == Kind::fault;
  if (known) co_return;
  trouble_.reset();
  if (!fault && !stopped && status.servo) co_return;
  const Failure why = co_await why_not(status);
  trouble_ = ArmTrouble{fault ? Kind::fault : stopped ? Kind::stopped : Kind::off, why};
}

Task<Result<void>> MotomanControl::take() {
  Result<MotomanStatus> status = co_await link_.status();
  if (!status) co_return lost(status.error());
  const bool locked = is_locked(*status);
  if (!locked) {
    if (has_alarm(*status)) {
      const Result<void> reset = co_await link_.reset();
      if (!reset && reset.error().symbol != "refused") co_return lost(reset.error());
    }
    if (status->command_hold) {
      const Result<void> released = co_await link_.turn(MotomanSwitch::hold, false);
      if (!released) co_return lost(released.error());
    }
    status = co_await link_.status();
    if (!status) co_return lost(status.error());
  }
  const bool in_the_way = locked || has_alarm(*status) || is_held(*status);
  if (in_the_way) {
    const Failure why = co_await why_not(*status);
    co_return fail(why);
  }
  if (status->servo) co_return Result<void>();
  Result<void> on = co_await switch_on();
  co_return on;
}

// Where the pendant has control already the order is refused, and nothing is left to give back.
Task<Result<void>> MotomanControl::release() {
  const Result<MotomanStatus> status = co_await link_.status();
  if (!status) co_return lost(status.error());
  if (!status->servo) co_return Result<void>();
  const Result<void> off = co_await link_.turn(MotomanSwitch::servo, false);
  if (!off && off.error().symbol != "refused") co_return lost(off.error());
  co_return off;
}

Task<Result<void>> MotomanControl::switch_on() {
  const Result<void> turned = co_await link_.turn(MotomanSwitch::servo, true);
  if (!turned && turned.error().symbol == "refused") {
    co_return fail("not-in-control", "the controller does not switch its servos on, as with its emergency stop pressed",
                   turned.error().subject);
  }
  if (!turned) co_return lost(turned.error());
  const Time deadline = executor_.now() + servo_time;
  while (executor_.now() < deadline) {
    const Result<MotomanStatus> status = co_await link_.status();
    if (!status) co_return lost(status.error());
    if (status->servo) co_return Result<void>();
    co_await sleep(executor_, look_again);
  }
  co_return fail("not-in-control", "the controller's servos do not come on");
}

Task<Result<void>> MotomanControl::ready_to_move(MotomanStatus status) {
  if (!may_move(status)) {
    const Failure why = co_await why_not(status);
    co_return fail(why);
  }
  if (!status.command_hold) co_return Result<void>();
  const Result<void> released = co_await link_.turn(MotomanSwitch::hold, false);
  if (!released) co_return lost(released.error());
  co_return Result<void>();
}

}  // namespace pizarra::arm
