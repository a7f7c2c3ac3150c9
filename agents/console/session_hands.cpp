// The arm in the page's hands: how long the line is, and jogs that last while the page holds on.

#include <algorithm>
#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/session.hpp"
#include "agents/runtime/follow.hpp"

namespace pizarra::console {

namespace {

double milliseconds(Duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

Datum hold_fact(const Datum& robot, const std::string& client, const Datum& count) {
  return list("hold"_sym, robot, Datum::symbol(client), count);
}

}  // namespace

// A page that takes in nothing gets no stamps, and what it says counts as late.
Task<void> Session::keep_beating() {
  while (true) {
    if (voice_.is_free()) {
      const std::optional<Duration> measured = pulse_.round_trip();
      voice_.say(fmt::format("{{\"pulse\":{},\"deadline\":{:.0f},\"rtt\":{:.1f}}}", pulse_.beat(setup_.executor.now()),
                             milliseconds(pulse_.deadline()), measured ? milliseconds(*measured) : -1.0));
    }
    const Time next = setup_.executor.now() + (in_hand_ ? Pulse::quick : Pulse::slow);
    co_await hands_changed_.wait(next);
  }
}

Task<void> Session::follow_hands() {
  const Datum ours = list("commander"_sym, "?robot"_sym, Datum::symbol(setup_.name));
  std::size_t arms = 0;
  const auto take = [this, &arms](Change change) -> Task<void> {
    if (change.resynchronised) arms = 0;
    arms = arms + change.added.size() - std::min(arms + change.added.size(), change.removed.size());
    in_hand_ = arms > 0;
    hands_changed_.wake_all();
    co_return;
  };
  co_await runtime::follow(context_, ours, take);
}

void Session::stamp(const Datum& form) { pulse_.came_back(form[1].integer(), setup_.executor.now()); }

// It comes two ways, and counts once: the page counts its requests upwards.
void Session::jog(const Datum& form) {
  const Number number = form[1].integer();
  if (number <= newest_jog_) return;
  newest_jog_ = number;
  const Duration deadline = pulse_.deadline();
  if (!pulse_.is_fresh(form[4].integer(), setup_.executor.now(), deadline)) {
    return voice_.refuse(number, "late", "this came too late to move the arm for");
  }
  if (jog_) return voice_.refuse(number, "busy", "this page holds on to a jog already");
  // From here on a release counts, before the request begins too.
  jog_ = Jog{number, form[2], deadline};
  const bool begun = begin_request(number, jog_while_held(number, form[2], form[3], deadline));
  if (!begun) jog_.reset();
}

Task<void> Session::jog_while_held(Number number, Datum robot, Datum direction, Duration deadline) {
  const Datum operation = list("jog"_sym, direction, milliseconds(deadline));
  const std::string agent(robot.text());
  Result<Datum> ended = Datum();
  Result<Revision> held = Revision();
  if (!jog_->released) held = co_await tell_hold(robot);
  if (!held) ended = fail(held);
  const bool wanted = held && !jog_->released;
  if (wanted) ended = co_await answer_of(agent, operation);
  co_await take_hold_back(robot);
  jog_.reset();
  voice_.say(ended ? reply_text(number, *ended) : refusal_text(number, ended.error()));
}

Task<Result<Revision>> Session::tell_hold(Datum robot) {
  Transaction telling;
  telling.tell(hold_fact(robot, setup_.name, to_datum(++holds_told_)), {}, service_.presence());
  Result<Revision> told = co_await context_.board.transact(std::move(telling));
  co_return told;
}

Task<void> Session::renew_hold(Datum robot) {
  // The arm stops where none has come.
  [[maybe_unused]] const Result<Revision> told = co_await tell_hold(robot);
}

Task<void> Session::take_hold_back(Datum robot) {
  const Datum pattern = hold_fact(robot, setup_.name, "?"_sym);
  // One that is not taken back goes with the page's presence.
  [[maybe_unused]] const Result<Revision> taken = co_await context_.board.retract(pattern);
}

// One at a time is on its way to the board: where that is slow, the arm stops.
void Session::hold_on(const Datum& form) {
  const bool ours = jog_ && !jog_->released && jog_->number == form[1].integer();
  const bool counts = ours && pulse_.is_fresh(form[2].integer(), setup_.executor.now(), jog_->deadline);
  if (counts && holding_.done()) holding_ = setup_.executor.spawn(renew_hold(jog_->robot));
}

void Session::release(const Datum& form) {
  if (!jog_ || jog_->released || jog_->number != form[1].integer()) return;
  jog_->released = true;
  letting_go_ = setup_.executor.spawn(take_hold_back(jog_->robot));
}

}  // namespace pizarra::console
