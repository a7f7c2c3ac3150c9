#include "agents/robot/rest_watch.hpp"

#include "blackboard/time/pace.hpp"
#include "drivers/arm/meeting.hpp"

namespace pizarra::robot {

namespace {

constexpr Duration full_telling = 1s;  // a board that restarted has forgotten what it was told

}  // namespace

RestWatch::RestWatch(Executor& executor, ArmConnection& arm, ArmControl& control, ArmFacts& facts, Duration tell_period)
    : executor_(executor), arm_(arm), control_(control), facts_(facts), tell_period_(tell_period), look_now_(executor) {
  // Any motion from here on is nobody's, and is looked for at once.
  control.on_stop_at_rest = [this] {
    if (!arm_.is_there()) return;
    arm_.forget_braking();
    look_now_.wake_all();
  };
}

Task<void> RestWatch::keep() {
  Pace pace(executor_, tell_period_);
  Time told = executor_.now();
  Time next = told;
  bool early = false;
  while (true) {
    if (!early) {
      const Duration beat = pace.pause();
      next = executor_.now() + (arm_.is_there() ? beat : reconnect_pause);
    }
    early = co_await look_now_.wait(next);
    const Time now = executor_.now();
    if (now - told >= full_telling) {
      facts_.forget_told();
      told = now;
    }
    if (!control_.running()) co_await look();
  }
}

Task<void> RestWatch::look() {
  if (!arm_.is_there()) {
    const Result<void> again = co_await arm_.connect();
    if (!again) arm_.lose(again.error());
  } else {
    co_await look_at_arm();
  }
  // A motion that began meanwhile tells for itself.
  if (control_.running()) co_return;
  const Result<void> told = co_await facts_.tell();
  if (!told) facts_.forget_told();
}

Task<void> RestWatch::look_at_arm() {
  const std::uint64_t motion = control_.motions();
  const Result<arm::ArmReading> reading = co_await arm_.driver().read();
  // Of a motion that began meanwhile it says nothing that is wrong.
  if (control_.motions() != motion) co_return;
  if (!reading) {
    arm_.lose(reading.error());
    co_return;
  }
  facts_.set_reading(arm_.model(), *reading);
  const bool stray = arm::moves_for_nobody(*reading) && !arm_.is_braking();
  if (!stray) co_return;
  facts_.set_arm("stopped", "MOVED_BY_ITSELF");
  const Result<void> braked = co_await arm_.brake();
  if (!braked) arm_.lose(braked.error());
}

}  // namespace pizarra::robot
