#include "agents/coordinator/pursue/pursuit.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

// Bounds of one goal. A tower of four takes about ten operations; every disturbance costs a few more.
constexpr int most_pauses = 3;
constexpr int most_slips = 5;
constexpr int most_rounds = 150;
constexpr int most_plans = 30;
constexpr int most_failures = 25;
constexpr int most_failures_in_a_row = 5;  // of one operation, while no other succeeds
// Failures of one operation till something else is tried.
constexpr int failures_till_otherwise = 2;
// Verdicts of one attempt after another that may come of a camera that was moved.
constexpr int most_doubts = 3;

// The operation that follows this one, unless something differs. What must hold after that is not known yet.
NextOperation once_done(const NextOperation& done) {
  return {done.index + 1, {done.rest.begin() + 1, done.rest.end()}, done.needed_after, {}};
}

// What ends the pursuit whatever else might be tried.
bool is_final(const Failure& failure) { return failure.symbol == "interrupted" || failure.symbol == "absent"; }

// The camera is to be found before anything else is done.
bool is_of_the_camera(const Failure& failure) { return failure.symbol == "camera-doubtful"; }

bool is_of_how_it_lies(const Failure& failure) {
  constexpr std::string_view symbols[] = {"stopped", "missed", "no-convergence", "no-effect"};
  return std::ranges::find(symbols, failure.symbol) != std::end(symbols);
}

}  // namespace

Task<Result<void>> Pursuit::run(Goal goal) {
  hold_up_.went_on();
  search_.begin();
  int doubts = 0;
  while (true) {
    const Result<void> outcome = co_await attempt(goal);
    // What ended it may not be so.
    const bool in_doubt = !outcome && !is_final(outcome.error()) && surroundings_.scene().camera().doubtful();
    if (in_doubt && ++doubts <= most_doubts) continue;
    const bool held_up = !outcome && is_hold_up(outcome.error());
    if (!held_up) co_return outcome;
    const Result<void> over = co_await hold_up_.await_end(outcome.error());
    if (!over) co_return over;
  }
}

Task<Result<void>> Pursuit::attempt(Goal goal) {
  const Result<void> tracking = co_await eyes_.track();
  if (!tracking) co_return tracking;
  const Result<void> looked = co_await eyes_.fresh_look();
  if (!looked) co_return looked;
  const Result<void> found = co_await find_camera();
  if (!found) co_return found;
  const std::vector<std::string> objects = objects_of(goal);
  const Result<void> there = co_await search_.look_for(goal);
  const bool goes_on = there || is_of_the_camera(there.error());
  if (!goes_on) co_return there;
  co_await search_.await_steady(objects);
  if (options_.open_loop) {
    const Result<void> carried_out = co_await carry_out_blindly(goal);
    co_return carried_out;
  }
  const Result<void> outcome = co_await rounds(goal);
  co_return outcome;
}

Task<Result<void>> Pursuit::find_camera() {
  while (!surroundings_.scene().camera().known()) {
    conditions_.rest();
    const Result<void> found = co_await survey_.run();
    // A motion that ended early says nothing of the camera.
    const bool ended_early = !found && found.error().symbol == "stopped";
    if (!ended_early) co_return found;
    const Result<void> over = co_await hold_up_.await_end(found.error());
    if (!over) co_return over;
  }
  co_return Result<void>();
}

Task<Result<void>> Pursuit::carry_out_blindly(Goal goal) {
  const Result<bool> planned = co_await replanning_.run(goal, objects_of(goal));
  if (!planned) co_return fail(planned);
  const Result<std::optional<NextOperation>> plan = co_await plan_.next(goal.number);
  if (!plan) co_return fail(plan);
  if (!*plan) co_return fail("off-plan", "the first plan does not fit what holds");
  const NextOperation first = **plan;
  conditions_.rest();
  for (std::size_t i = 0; i < first.rest.size(); ++i) {
    if (interruption_.raised()) co_return interruption_.failure();
    co_await runner_.run(first.index + i, first.rest[i]);
  }
  co_return Result<void>();
}

Task<Result<void>> Pursuit::rounds(Goal goal) {
  const std::vector<std::string> objects = objects_of(goal);
  Progress progress;
  room_.begin();
  for (int round = 0; round < most_rounds; ++round) {
    if (interruption_.raised()) co_return interruption_.failure();
    const Result<void> found = co_await find_camera();
    if (!found) co_return found;
    // The arm keeps out of the way of a hand at work.
    const bool calm = surroundings_.scene().calm();
    if (!calm) co_await search_.await_steady(objects);
    const Result<std::optional<NextOperation>> chosen = co_await choose(goal, progress);
    const bool to_find_camera = !chosen && is_of_the_camera(chosen.error());
    if (to_find_camera) continue;
    if (!chosen) co_return fail(chosen);
    if (!*chosen) continue;
    const NextOperation& next = **chosen;
    if (next.rest.empty()) {
      const bool is_outgrown = outgrows_plan(goal);
      if (is_outgrown) plan_.forget();
      if (is_outgrown) continue;
      const bool settled = co_await settles(goal);
      if (settled) co_return Result<void>();
      progress.expected.reset();
      progress.announced.reset();
      continue;
    }
    const Result<bool> changed = co_await room_.make(goal.number, next);
    const bool ends = !changed && is_hold_up(changed.error());
    if (ends) co_return fail(changed);
    const bool chooses_anew = !changed || *changed;
    if (chooses_anew) continue;
    const Result<void> done = co_await do_operation(next);
    if (done) {
      hold_up_.went_on();
      progress.expected = once_done(next);
      progress.announced = next.index + 1;
      progress.failures_of.erase(next.rest.front().name);
      progress.failures_in_a_row.clear();
      continue;
    }
    const Result<void> recovered = co_await recover(goal.number, next.rest.front(), done.error(), progress);
    if (!recovered) co_return recovered;
    co_await search_.await_steady(objects);
  }
  co_return fail("gave-up",
                 fmt::format("the goal was not reached in {} rounds of looking, choosing and acting", most_rounds));
}

Task<Result<std::optional<NextOperation>>> Pursuit::choose(Goal goal, Progress& progress) {
  const Result<std::optional<NextOperation>> next = co_await plan_.next(goal.number);
  if (!next) co_return next;
  if (!*next) {
    if (progress.expected) {
      const std::vector<Datum> lost = missing_from(surroundings_.beliefs(), progress.expected->needed);
      co_await differences_.tell(lost, "the rest of the plan");
    }
    progress.expected.reset();
    progress.announced.reset();
    if (++progress.plans > most_plans) co_return fail("gave-up", "too many plans came to nothing");
    std::vector<std::string> objects = objects_of(goal);
    const Result<bool> planned = co_await replanning_.run(goal, std::move(objects));
    if (!planned) co_return fail(planned);
    if (*planned) progress.announced = 0;
    co_return next;
  }
  const std::size_t index = (*next)->index;
  const bool unexpected = progress.expected && index != progress.expected->index;
  if (unexpected) co_await differences_.tell_unexpected(*progress.expected, index);
  if (progress.announced != index) co_await differences_.tell_still_serves(goal.number, **next);
  progress.expected = *next;
  progress.announced = index;
  co_return next;
}

Task<Result<void>> Pursuit::recover(std::int64_t goal, GroundOperation operation, Failure why, Progress& progress) {
  const bool ends = is_final(why) || is_hold_up(why);
  if (ends) co_return fail(why);
  if (why.symbol == "slipped") co_return co_await recover_from_slip(operation, std::move(why), progress);
  // A difference was told when it was noticed; what follows from it is not another one.
  progress.expected.reset();
  if (why.symbol == "difference" || is_of_the_camera(why)) {
    progress.announced.reset();
    co_await room_.make_below_carried(operation);
    co_return Result<void>();
  }
  const int failures = ++progress.failures_of[operation.name];
  const int in_a_row = ++progress.failures_in_a_row[operation.name];
  const bool too_often = ++progress.failures > most_failures || in_a_row > most_failures_in_a_row;
  if (too_often) co_return fail(why);
  const bool in_vain = failures % failures_till_otherwise == 0;
  if (in_vain) co_await try_otherwise(goal, operation, std::move(why));
  co_return Result<void>();
}

// How it lies is not to blame, so that it is grasped again as before.
Task<Result<void>> Pursuit::recover_from_slip(GroundOperation operation, Failure why, Progress& progress) {
  if (++progress.failures > most_failures) co_return fail(why);
  if (operation.name.size() < 2) co_return Result<void>();
  const Result<void> ready = co_await rescues_.let_it_lie(std::string(operation.name[1].text()));
  const bool ends = !ready && (is_final(ready.error()) || is_hold_up(ready.error()));
  if (ends) co_return ready;
  co_return Result<void>();
}

// Whatever comes of it is seen afterwards.
Task<void> Pursuit::try_otherwise(std::int64_t goal, GroundOperation operation, Failure why) {
  const bool hidden = why.symbol == "lost-sight" && why.subject.is_symbol();
  if (hidden) {
    const std::string missing(why.subject.text());
    co_await search_.clear_view_of(goal, missing);
    co_return;
  }
  const bool lies_badly = is_of_how_it_lies(why);
  if (lies_badly) co_await rescues_.loosen(operation.name);
}

Task<Result<void>> Pursuit::do_operation(NextOperation next) {
  const GroundOperation& operation = next.rest.front();
  conditions_.begin(operation, next.needed_after);
  const Result<void> done = co_await runner_.run(next.index, operation);
  if (done) co_return done;
  const Failure& why = done.error();
  if (why.symbol == "interrupted") co_return done;
  if (why.symbol == "difference") {
    std::vector<Datum> lost(why.subject.items().begin(), why.subject.items().end());
    co_await differences_.tell(std::move(lost), write(operation.name));
  } else {
    const std::string sentence = fmt::format("{} failed: {}", write(operation.name), why.sentence);
    co_await story_.tell("operation", sentence, failure_to_datum(why));
  }
  co_return done;
}

bool Pursuit::outgrows_plan(const Goal& goal) const {
  const bool quantifies = forms::quantified_over(goal.facts, domain_.perception().sees()) != forms::Quantified::none;
  return quantifies && !forms::goal_holds(goal.facts, surroundings_.beliefs(), planning_.objects());
}

Task<bool> Pursuit::settles(Goal goal) {
  // It is reached when it shows, and not because something hides that it does not hold.
  surroundings_.doubt_hidden();
  const std::vector<std::string> objects = objects_to_lie_still(goal);
  Time since = context_.executor.now();
  Time last = since;
  std::uint64_t sights_before = surroundings_.scene().sightings().looks();
  int pauses = 0;
  int slips = 0;
  for (int looks = 0; looks < options_.settle_looks || last < since + options_.settle; ++looks) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return false;
    // While nobody knows where the camera stands, no look proves the goal.
    const bool counts = !interruption_.raised() && surroundings_.scene().camera().known();
    if (!counts) co_return false;
    const std::vector<Datum> lost = forms::unmet_parts(goal.facts, surroundings_.beliefs(), planning_.objects());
    if (!lost.empty()) {
      co_await differences_.tell(lost, "the goal");
      co_await search_.await_steady(objects_of(goal));
      co_return false;
    }
    const Time now = context_.executor.now();
    const std::uint64_t sights = surroundings_.scene().sightings().looks();
    const bool paused = now - last > options_.settle;
    const bool moves = surroundings_.scene().moved_within(sights - sights_before, objects);
    // The time to settle begins anew after a pause, in which nobody looked, and while an object slips, which may fall.
    // But only so often: some eyes are always as slow, or as noisy.
    const bool anew = (paused && pauses++ < most_pauses) || (moves && slips++ < most_slips);
    if (anew) {
      looks = 0;
      since = now;
      sights_before = sights;
    }
    last = now;
  }
  co_return true;
}

std::vector<std::string> Pursuit::objects_to_lie_still(const Goal& goal) const {
  const bool quantifies = forms::quantified_over(goal.facts, domain_.perception().sees()) != forms::Quantified::none;
  if (!quantifies) return objects_of(goal);
  std::vector<std::string> out;
  for (const auto& [name, sighting] : surroundings_.scene().sightings().all()) {
    if (name != options_.gripper.mark) out.push_back(name);
  }
  return out;
}

}  // namespace pizarra::coordinator
