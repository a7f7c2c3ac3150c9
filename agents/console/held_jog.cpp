#include "agents/console/held_jog.hpp"

#include "agents/console/change_text.hpp"

namespace pizarra::console {

namespace {

Datum hold_fact(const Datum& robot, const Datum& client, const Datum& count) {
  return list("hold"_sym, robot, client, count);
}

}  // namespace

void HeldJog::jog(const Datum& form) {
  const std::int64_t number = form[1].integer();
  if (number <= newest_) return;
  newest_ = number;
  const Duration deadline = pulse_.deadline();
  if (!is_fresh(form[4], deadline)) {
    return voice_.refuse(number, "late", "this came too late to move the arm for");
  }
  if (jog_) return voice_.refuse(number, "busy", "this page holds on to a jog already");
  // From here on a release counts, before the request begins too.
  jog_ = Jog{number, form[2], deadline};
  const bool begun = requests_.begin(number, jog_while_held(number, form[2], form[3], deadline));
  if (!begun) jog_.reset();
}

void HeldJog::hold_on(const Datum& form) {
  const bool counts = holds(form[1]) && is_fresh(form[2], jog_->deadline);
  if (counts && holding_.done()) holding_ = board_.executor().spawn(renew_hold(jog_->robot));
}

void HeldJog::release(const Datum& form) {
  if (!holds(form[1])) return;
  jog_->released = true;
  letting_go_ = board_.executor().spawn(take_hold_back(jog_->robot));
}

bool HeldJog::is_fresh(const Datum& stamp, Duration deadline) const {
  return pulse_.is_fresh(stamp.integer(), board_.executor().now(), deadline);
}

bool HeldJog::holds(const Datum& number) const { return jog_ && !jog_->released && jog_->number == number.integer(); }

Task<void> HeldJog::jog_while_held(std::int64_t number, Datum robot, Datum direction, Duration deadline) {
  const Datum operation = list("jog"_sym, direction, milliseconds(deadline));
  const std::string agent(robot.text());
  Result<Datum> ended = Datum();
  Result<Revision> held = Revision();
  if (!jog_->released) held = co_await tell_hold(robot);
  if (!held) ended = fail(held);
  const bool wanted = held && !jog_->released;
  if (wanted) ended = co_await board_.call(agent, operation);
  co_await take_hold_back(robot);
  jog_.reset();
  voice_.say(ended ? reply_text(number, *ended) : refusal_text(number, ended.error()));
}

Task<Result<Revision>> HeldJog::tell_hold(Datum robot) {
  Transaction telling;
  telling.tell(hold_fact(robot, board_.client(), to_datum(++holds_told_)), {}, board_.presence());
  Result<Revision> told = co_await board_.facts().transact(std::move(telling));
  co_return told;
}

Task<void> HeldJog::renew_hold(Datum robot) {
  // The arm stops where none has come.
  [[maybe_unused]] const Result<Revision> told = co_await tell_hold(robot);
}

Task<void> HeldJog::take_hold_back(Datum robot) {
  const Datum pattern = hold_fact(robot, board_.client(), "?"_sym);
  // One that is not taken back goes with the page's presence.
  [[maybe_unused]] const Result<Revision> taken = co_await board_.facts().retract(pattern);
}

}  // namespace pizarra::console
