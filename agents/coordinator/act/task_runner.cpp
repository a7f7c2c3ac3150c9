#include "agents/coordinator/act/task_runner.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "agents/coordinator/retried_commit.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

// How near a held object's mark is to where it should be.
constexpr double held_mm = 25;
constexpr int held_looks = 12;
// Where the arm does not reach as high as it should, it goes inwards or outwards by as much, and tries again.
constexpr double retreat_mm = 20;
constexpr double height_tolerance_mm = 2;
constexpr int most_rises = 30;  // every second one of them after a retreat

}  // namespace

Task<Result<Revision>> TaskRunner::tell(const Datum& fact) {
  Transaction transaction;
  transaction.tell(fact);
  return commit(context_.board, context_.executor, std::move(transaction));
}

Task<Result<void>> TaskRunner::run(std::size_t index, GroundOperation operation) {
  const Result<std::vector<Datum>> steps = domain_.micro_tasks().expand(operation.name);
  if (!steps) co_return fail(steps);
  aims_.reset();
  const std::string sentence = fmt::format("operation {}: {}", index + 1, write(operation.name));
  co_await story_.tell("operation", sentence, operation.name);
  co_await tell(list("operation"_sym, index, operation.name, "running"_sym));
  Result<void> done = co_await run_steps(*steps);
  const bool is_to_show = done && !options_.open_loop;
  if (is_to_show) done = co_await carried_.keep(await_effects(operation));
  const Datum state = Datum::symbol(done ? "done" : "failed");
  co_await tell(list("operation"_sym, index, operation.name, state));
  co_return done;
}

Task<Result<void>> TaskRunner::improvise(std::vector<Datum> steps) {
  conditions_.rest();
  aims_.reset();
  // A slip of the step before is not told again.
  if (carried_.is_lost()) carried_.end();
  const Result<void> done = co_await run_steps(std::move(steps));
  co_return done;
}

Task<Result<void>> TaskRunner::run_steps(std::vector<Datum> steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Result<void> fine = may_move(surroundings_, conditions_);
    if (!fine) co_return fine;
    co_await tell(list("micro-task"_sym, i, steps[i], "running"_sym));
    const Result<void> done = co_await carried_.keep(run_step(steps[i]));
    const Datum state = Datum::symbol(done ? "done" : "failed");
    co_await tell(list("micro-task"_sym, i, steps[i], state));
    const bool goes_on = done || (options_.open_loop && !interruption_.raised());
    if (!goes_on) co_return done;
  }
  co_return Result<void>();
}

Task<Result<void>> TaskRunner::run_step(Datum step) {
  const std::string_view name = step.head();
  if (name == "raise") return raise_to(carried_.height_mm());
  if (name == "align") return servo_.run(step[1], false);
  if (name == "lower") return servo_.run(step[1], true);
  if (name == "close") return close();
  if (name == "release") return release();
  if (name == "turn-fingers") return turn_fingers(std::string(step[1].text()));
  if (name == "square-up") return arm_.face(0);
  if (name == "make-room") return pushes_.make_room(std::string(step[1].text()));
  if (name == "push-over") return pushes_.push_over(std::string(step[1].text()));
  if (name == "check-held" && options_.open_loop) return raise_to(carried_.height_mm());
  if (name == "check-held") return check_held(std::string(step[1].text()));
  return open(aims_.opening_around(step[1].text(), options_.gripper.openings.wide_mm));
}

Task<Result<void>> TaskRunner::open(double opening_mm) {
  carried_.end();
  const Result<double> opened = co_await arm_.grip(opening_mm);
  if (!opened) co_return fail(opened);
  co_return Result<void>();
}

Task<Result<void>> TaskRunner::turn_fingers(std::string object) {
  const double wanted_deg = surroundings_.scene().fingers_deg(object);
  const Result<void> turned = co_await arm_.face(wanted_deg);
  co_return turned;
}

Task<Result<void>> TaskRunner::close() {
  conditions_.commit();
  const Result<double> opening = co_await arm_.grip(0);
  if (!opening) co_return fail(opening);
  const bool is_held = domain_.edge_like(*opening).has_value();
  if (is_held) carried_.begin(*opening);
  if (is_held) co_return Result<void>();
  co_return fail("missed", fmt::format("the gripper closed to {:.0f} mm", *opening), to_datum(*opening));
}

Task<Result<void>> TaskRunner::release() {
  conditions_.commit();
  carried_.end();
  const Result<double> opened = co_await arm_.grip(options_.gripper.openings.normal_mm);
  if (!opened) co_return fail(opened);
  co_return Result<void>();
}

// Far out it goes up as far as it can first, over what stands behind, and then on from nearer to its foot. Where it
// comes no nearer, as beside its foot, it goes on from farther out.
Task<Result<void>> TaskRunner::go_up(double missing_mm, double height_mm) {
  double aside_mm = -retreat_mm;
  std::optional<Eigen::Vector3d> before;
  for (int i = 0; i < most_rises; ++i) {
    const ServoCommand::Motion motion = missing_mm > 0 ? ServoCommand::Motion::up : ServoCommand::Motion::down;
    const ServoCommand command{0, motion, std::abs(missing_mm)};
    Result<void> moved = co_await arm_.perform(command);
    const bool too_high = !moved && missing_mm > 0 && is_beyond_reach(moved.error());
    const ServoCommand aside{0, ServoCommand::Motion::extend, aside_mm};
    if (too_high) moved = co_await arm_.perform(aside);
    if (!moved) co_return moved;
    const Result<Eigen::Vector3d> grip = co_await arm_.grip_centre();
    if (!grip) co_return fail(grip);
    const bool rests = before && (*grip - *before).norm() < height_tolerance_mm;
    if (rests) aside_mm = -aside_mm;
    before = *grip;
    missing_mm = height_mm - grip->z();
    if (std::abs(missing_mm) <= height_tolerance_mm) co_return Result<void>();
  }
  co_return fail("unreachable", "the arm does not reach its travel height", to_datum(missing_mm));
}

// One look at rest that shows it will do.
Task<Result<void>> TaskRunner::look_for_mark(bool has_moved) {
  const Sightings& sightings = surroundings_.scene().sightings();
  Result<void> looked;
  const bool at_rest = !has_moved && surroundings_.shows_rest();
  if (!at_rest) looked = co_await eyes_.look_at_rest();
  const bool is_shown = !looked || sightings.recent(options_.gripper.mark, 1);
  if (!is_shown) looked = co_await eyes_.fresh_look();
  co_return looked;
}

// Only vision can tell whether the mark stands where the arm believes it to be, so a raise ends with a look.
Task<Result<void>> TaskRunner::raise_to(double height_mm) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Result<Eigen::Vector3d> grip = co_await arm_.grip_centre();
    if (!grip) co_return fail(grip);
    const double missing = height_mm - grip->z();
    const bool moves = std::abs(missing) > height_tolerance_mm;
    if (moves) {
      const Result<void> moved = co_await go_up(missing, height_mm);
      if (!moved) co_return moved;
    }
    const Result<void> looked = co_await look_for_mark(moves);
    if (!looked) co_return looked;
    const Scene& scene = surroundings_.scene();
    if (scene.sightings().recent(options_.gripper.mark, 3)) co_return Result<void>();
    // A camera that was knocked against may not show it as high up: the arm's word will do.
    if (!scene.mark_in_view()) co_return Result<void>();
    // Out of the camera's view, as after home: the ready pose is before it.
    const Datum ready = list("ready"_sym);
    const Result<Datum> readied = co_await arm_.ask(ready);
    if (!readied) co_return fail(readied);
  }
  surroundings_.doubt_camera();
  co_return fail("lost-sight", "the end effector's mark is not seen", Datum::symbol(options_.gripper.mark));
}

Task<Result<void>> TaskRunner::check_held(std::string object) {
  for (int i = 0; i < held_looks; ++i) {
    const bool is_shown = i == 0 && surroundings_.shows_rest();
    Result<void> looked;
    if (!is_shown) looked = co_await eyes_.fresh_look();
    if (!looked) co_return looked;
    const std::optional<Eigen::Vector3d> grip = surroundings_.scene().grip_mm();
    const Sighting* seen = surroundings_.scene().sightings().find(object);
    if (!grip || !seen || !surroundings_.scene().sightings().recent(object, 1)) continue;
    const Eigen::Vector3d wanted = *grip + surroundings_.scene().set_back_mm(object);
    if ((seen->place_mm - wanted).norm() < held_mm) co_return Result<void>();
    // The raised arm took nothing with it.
    if (surroundings_.scene().still({object})) break;
  }
  co_return fail("missed", fmt::format("{} is not seen between the fingers", object), Datum::symbol(object));
}

Task<Result<void>> TaskRunner::await_effects(GroundOperation operation) {
  const Time deadline = context_.executor.now() + CoordinatorOptions::effects_patience;
  while (true) {
    const Facts& beliefs = surroundings_.beliefs();
    bool effective = true;
    for (const Datum& fact : operation.adds) effective = effective && beliefs.contains(fact);
    if (effective) co_return Result<void>();
    if (interruption_.raised() || carried_.is_lost() || context_.executor.now() > deadline) break;
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return looked;
  }
  co_return fail("no-effect", fmt::format("{} was carried out, but its effect is not seen", write(operation.name)),
                 operation.name);
}

}  // namespace pizarra::coordinator
