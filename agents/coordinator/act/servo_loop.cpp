#include <cmath>
#include <fmt/format.h>

#include "agents/coordinator/act/task_runner.hpp"
#include "agents/coordinator/retried_commit.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

// An approach takes about ten motions; one that follows a block that is moved about may take some more.
constexpr int most_looks = 120;
constexpr int most_unseen = 40;

double tenths(double value) { return std::round(value * 10) / 10; }

}  // namespace

Task<Result<Revision>> TaskRunner::tell_servo(int state, const Datum& target, ServoPixels errors) {
  Transaction transaction;
  transaction.tell(
      list("servo"_sym, state, target_name(target), tenths(errors.x_px), tenths(errors.y_px), tenths(errors.depth_mm)),
      {}, service_.presence());
  return commit(context_.board, context_.executor, std::move(transaction));
}

// Look, decide, move; nothing is remembered from look to look but the state, to tell when a target runs away.
Task<Result<void>> TaskRunner::servo(Datum target, bool descend) {
  int unseen = 0;
  int state_before = 0;
  for (int i = 0; i < most_looks; ++i) {
    const Result<void> fine = check();
    if (!fine) co_return fine;
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return looked;
    const Result<Aim> aim = aims_.at(target);
    if (!aim) {
      const Failure& why = aim.error();
      if (why.symbol != "unseen") co_return fail(aim);
      if (++unseen > most_unseen) co_return fail("lost-sight", why.sentence, why.subject);
      continue;
    }
    unseen = 0;
    const ServoErrors errors = servo_errors(*aim, *surroundings_.scene().view(), options_.gripper.mark_before_grip_mm,
                                            options_.travel_height_mm);
    const ServoCommand command = servo_command(errors, options_.servo, descend);
    const ServoPixels told = servo_pixels(*aim, *surroundings_.scene().view());
    co_await tell_servo(command.state, target, told);
    if (command.state < 3 && state_before >= 3) {
      const std::string sentence = fmt::format("{} was moved during the approach: following it", write(target));
      co_await story_.tell("servo", sentence, target_name(target));
    }
    state_before = command.state;
    if (command.motion == ServoCommand::Motion::done) co_return Result<void>();
    const Result<void> moved = co_await arm_.perform(command);
    if (!moved) co_return moved;
  }
  co_return fail("no-convergence", fmt::format("the arm did not come to {}", write(target)), target_name(target));
}

}  // namespace pizarra::coordinator
