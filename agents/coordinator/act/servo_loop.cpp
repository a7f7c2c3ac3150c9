#include "agents/coordinator/act/servo_loop.hpp"

#include <cmath>
#include <fmt/format.h>

#include "agents/coordinator/retried_commit.hpp"
#include "blackboard/time/latch.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

// An approach takes about ten motions; one that follows a block that is moved about may take some more.
constexpr int most_motions = 120;
constexpr int most_unseen = 80;
// Where the arm does not come to a place at its height, it goes down by as much and tries again.
constexpr double lowering_mm = 30;
// Where the links stand at their limit no track takes over: the arm goes back by as much first.
constexpr double back_off_mm = 40;
// Beside a motion, until it is asked again whether a look has come.
constexpr Duration watch_patience = 1s;

// Nearer than anything is laid down by itself. There the arm comes down from above, and does not come in low.
bool is_near_the_foot(const Aim& aim) {
  return (aim.wanted_mm - aim.foot_mm).head<2>().norm() < TableArea().reach_low_mm;
}

double tenths(double value) { return std::round(value * 10) / 10; }

}  // namespace

Result<void> may_move(const Surroundings& surroundings, const StandingConditions& conditions) {
  if (!surroundings.scene().camera().known()) {
    return fail("camera-doubtful", "the camera may have been moved: where things are is not known well enough");
  }
  return conditions.check(surroundings.beliefs());
}

Task<Result<Revision>> ServoLoop::tell(int state, const Datum& target, ServoPixels errors) {
  Transaction transaction;
  transaction.tell(
      list("servo"_sym, state, target_name(target), tenths(errors.x_px), tenths(errors.y_px), tenths(errors.depth_mm)),
      {}, service_.presence());
  return commit(context_.board, context_.executor, std::move(transaction));
}

// Sideways all the way that is missing, where turning and stretching did not bring it. Over the table it goes lower
// where it does not come there at its height, as long as it passes over all that stands.
Task<Result<void>> ServoLoop::go_straight(Aim aim, ServoCommand stalled) {
  const Result<Eigen::Vector3d> grip = co_await arm_.grip_centre();
  if (!grip) co_return fail(grip);
  Eigen::Vector3d there = *grip + aim.wanted_mm - aim.followed_mm;
  there.z() = grip->z();
  Result<void> moved = co_await arm_.move_to(there);
  const bool over_the_table = stalled.state < 3 && stalled.motion == ServoCommand::Motion::extend;
  if (moved || !over_the_table || !is_beyond_reach(moved.error())) co_return moved;
  const ServoCommand back{2, stalled.motion, std::copysign(back_off_mm, -stalled.amount)};
  const Result<void> backed = co_await arm_.perform(back);
  if (!backed) co_return backed;
  for (; there.z() >= aims_.clear_height_mm(); there.z() -= lowering_mm) {
    moved = co_await arm_.move_to(there);
    if (moved || !is_beyond_reach(moved.error())) break;
  }
  co_return moved;
}

// Where the links alone do not come down, as near the arm's foot, a track carries them aside.
Task<Result<void>> ServoLoop::go_down(double down_mm) {
  const Result<Eigen::Vector3d> grip = co_await arm_.grip_centre();
  if (!grip) co_return fail(grip);
  const Eigen::Vector3d below = *grip - Eigen::Vector3d(0, 0, down_mm);
  co_return co_await arm_.move_to(below);
}

struct ServoLoop::Cut {
  bool begun = false;
  Event ended;
};

Task<void> ServoLoop::cut_short(Datum target, Eigen::Vector3d wanted_mm, Cut& cut) {
  while (!cut.begun) {
    const Time soon = context_.executor.now() + watch_patience;
    co_await surroundings_.look_after(surroundings_.looks(), soon);
    const Result<Aim> aim = aims_.at(target);
    const bool is_moved = aim && (aim->wanted_mm - wanted_mm).norm() > ServoLimits::follow_mm;
    cut.begun = is_moved && arm_.is_asked();
  }
  // A motion that was not stopped goes on to its end.
  [[maybe_unused]] const Result<void> stopped = co_await arm_.cut_short();
  cut.ended.set();
}

Task<Result<bool>> ServoLoop::move(Datum target, Aim aim, ServoCommand command, bool stalled) {
  const std::optional<double> yaw_deg = surroundings_.scene().tool_yaw_deg();
  Cut cut{false, Event(context_.executor)};
  const Job watch = context_.executor.spawn(cut_short(target, aim.wanted_mm, cut));
  Result<void> moved;
  if (stalled) moved = co_await go_straight(aim, command);
  if (!stalled) moved = co_await arm_.perform(command);
  const bool links_end = !moved && command.motion == ServoCommand::Motion::down && is_beyond_reach(moved.error());
  if (links_end) moved = co_await go_down(command.amount);
  // The next motion must not meet the stop.
  if (cut.begun) co_await cut.ended.wait();
  const bool was_cut = cut.begun && !moved && was_cut_short(moved.error());
  if (!was_cut && !moved) co_return fail(moved);
  if (!was_cut) co_return true;
  const std::string sentence = fmt::format("{} was moved: the motion towards it is cut short", write(target));
  co_await story_.tell("servo", sentence, target_name(target));
  // The wrist takes a turn back only after it.
  const bool is_turned = command.motion == ServoCommand::Motion::turn && yaw_deg;
  if (is_turned) moved = co_await arm_.face(*yaw_deg);
  if (is_turned && !moved) co_return fail(moved);
  co_return false;
}

// Look, decide, move. From look to look it remembers two things: for how many looks it has not seen its target, and its
// last command. That one tells when a target runs away, and when the arm does not come on by turning and stretching.
Task<Result<void>> ServoLoop::run(Datum target, bool descend) {
  int unseen = 0;
  ServoCommand before{0, ServoCommand::Motion::done, 0};
  for (int i = 0; i < most_motions; ++i) {
    const Result<void> fine = may_move(surroundings_, conditions_);
    if (!fine) co_return fine;
    const bool is_shown = i == 0 && surroundings_.shows_rest();
    Result<void> looked;
    if (!is_shown) looked = co_await eyes_.look_at_rest();
    if (!looked) co_return looked;
    const Result<void> held = carried_.check();
    if (!held) co_return held;
    const Result<Aim> aim = aims_.at(target);
    if (!aim) {
      const Failure& why = aim.error();
      if (why.symbol != "unseen") co_return fail(aim);
      if (++unseen > most_unseen) co_return fail("lost-sight", why.sentence, why.subject);
      continue;
    }
    unseen = 0;
    if (is_near_the_foot(*aim)) carried_.go_high();
    const ServoErrors errors =
        servo_errors(*aim, *surroundings_.scene().view(), options_.gripper.mark_before_grip_mm, carried_.height_mm());
    const ServoCommand command = servo_command(errors, descend);
    const ServoPixels told = servo_pixels(*aim, *surroundings_.scene().view());
    co_await tell(command.state, target, told);
    if (command.state < 3 && before.state >= 3) {
      const std::string sentence = fmt::format("{} was moved during the approach: following it", write(target));
      co_await story_.tell("servo", sentence, target_name(target));
    }
    if (command.motion == ServoCommand::Motion::done) co_return Result<void>();
    const bool stalled = has_stalled(command, before);
    before = command;
    const Result<bool> moved = co_await move(target, *aim, command, stalled);
    if (!moved) co_return fail(moved);
    // A motion that was cut short does not show where the arm's limits are.
    if (!*moved) before.motion = ServoCommand::Motion::done;
  }
  co_return fail("no-convergence", fmt::format("the arm did not come to {}", write(target)), target_name(target));
}

}  // namespace pizarra::coordinator
