#include "agents/coordinator/pursue/goal_loop.hpp"

#include <fmt/format.h>

#include "agents/coordinator/geometry/seen_places.hpp"
#include "agents/coordinator/perceive/missing_objects.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration missing_pause = 1s;
constexpr const char* missing_shows = "what was missing is seen: going on";
constexpr Duration watch_pause = 300ms;
// How long nothing is tried of a kept goal that cannot be had as things are.
constexpr Duration hopeless_pause = 10s;

// As the state of a goal tells them.
Datum told_missing(const std::vector<std::string>& names) {
  std::vector<Datum> detail{"missing"_sym};
  for (const std::string& name : names) detail.push_back(Datum::symbol(name));
  return Datum::list(std::move(detail));
}

// From its second stage on, the state of a running goal names the stage, so that a new life goes on with it.
Datum told_in_stage(const Goal& goal, const Datum& detail) {
  if (goal.stage == 0) return detail;
  std::vector<Datum> told{"stage"_sym, to_datum(static_cast<std::int64_t>(goal.stage + 1))};
  if (detail != Datum()) told.push_back(detail);
  return Datum::list(std::move(told));
}

}  // namespace

Task<void> GoalLoop::resume() {
  co_await goal_.resume();
  const std::optional<Goal>& taken_up = goal_.current();
  // The plan may be that of the stage before.
  if (taken_up && taken_up->stage == 0) plan_.take_up(taken_up->number);
}

Task<void> GoalLoop::run() {
  while (true) {
    const Goal goal = co_await goal_.next();
    vigil_.clear_interrupt();
    const Result<void> outcome = co_await pursue(goal);
    co_await goal_.finish(goal, outcome);
  }
}

Task<Result<void>> GoalLoop::pursue(Goal goal) {
  const StagedGoal staged = staged_goal_of(goal.facts);
  if (staged.keeps) {
    const Result<void> ended = co_await keep(goal, staged);
    co_return ended;
  }
  const Result<void> outcome = co_await pursue_stages(goal, staged);
  co_return outcome;
}

Task<Result<void>> GoalLoop::pursue_stages(Goal goal, StagedGoal staged) {
  for (std::size_t i = goal.stage; i < staged.stages.size(); ++i) {
    const Goal stage{goal.number, staged.stages[i], i};
    const bool is_later = i > goal.stage;
    if (is_later) {
      std::string sentence = fmt::format("stage {} of {} holds; the next:", i, staged.stages.size());
      for (const Datum& form : staged.stages[i]) sentence += ' ' + write(form);
      plan_.forget();
      const Datum detail = told_in_stage(stage, Datum());
      co_await goal_.tell_progress(goal.number, "running", detail, "goal", sentence);
    }
    const Result<void> done = co_await pursue_patiently(stage, staged.patience);
    if (!done) co_return done;
  }
  co_return Result<void>();
}

Task<Result<void>> GoalLoop::pursue_patiently(Goal goal, Duration patience) {
  while (true) {
    const Result<void> done = co_await pursuit_.run(goal);
    const bool waits = !done && done.error().symbol == "missing-object" && patience > Duration::zero();
    if (!waits) co_return done;
    const Failure& missing = done.error();
    const Result<void> there = co_await await_missing(goal, missing, patience);
    if (!there) co_return there;
  }
}

Task<Result<void>> GoalLoop::await_missing(Goal goal, Failure missing, Duration patience) {
  const std::vector<std::string> names = names_of_missing(missing);
  const double seconds = std::chrono::duration<double>(patience).count();
  const std::string sentence = fmt::format("{}: waiting {:g} s for it", missing.sentence, seconds);
  const Datum told = told_in_stage(goal, told_missing(names));
  co_await goal_.tell_progress(goal.number, "running", told, "missing", sentence);
  const Time deadline = context_.executor.now() + patience;
  for (const std::string& name : names) {
    while (!surroundings_.scene().sightings().recent(name, 2)) {
      if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
      if (context_.executor.now() > deadline) {
        const std::string in_vain = fmt::format("{}, and {:g} s of waiting were in vain", missing.sentence, seconds);
        co_return fail("missing-object", in_vain, missing.subject);
      }
      const Result<bool> found = co_await eyes_.find(name);
      if (!found) co_return fail(found);
      const Result<void> looked = co_await eyes_.fresh_look();
      if (!looked) co_return looked;
      if (!*found) co_await sleep(context_.executor, missing_pause);
    }
  }
  const Datum nothing = told_in_stage(goal, Datum());
  const std::string seen = missing_shows;
  co_await goal_.tell_progress(goal.number, "running", nothing, "missing", seen);
  co_return Result<void>();
}

// It ends only when another goal, or none, is wanted.
Task<Result<void>> GoalLoop::keep(Goal goal, StagedGoal staged) {
  const Datum nothing;
  Failure told;
  bool holds = false;
  while (true) {
    const Result<void> done = co_await pursue_stages(goal, staged);
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    if (!done) {
      holds = false;
      const Failure& why = done.error();
      const Failure before = told;
      told = co_await keep_in_mind(goal.number, why, before);
      continue;
    }
    const std::string stands = fmt::format("goal {} is kept", goal.number);
    if (!holds) co_await goal_.tell_progress(goal.number, "kept", nothing, "result", stands);
    holds = true;
    told = Failure();
    while (holds && !vigil_.interrupted()) {
      co_await sleep(context_.executor, watch_pause);
      const std::vector<Datum> lost =
          forms::unmet_parts(staged.stages.front(), surroundings_.beliefs(), planning_.objects());
      if (lost.empty()) continue;
      holds = false;
      co_await differences_.tell(lost, "the goal that is kept");
      const std::string sentence = fmt::format("goal {} fell: it is built again", goal.number);
      co_await goal_.tell_progress(goal.number, "running", nothing, "plan", sentence);
    }
  }
}

Task<Failure> GoalLoop::keep_in_mind(std::int64_t goal, Failure why, Failure told) {
  if (why.symbol == "missing-object") {
    co_await await_sight(goal, why);
    co_return Failure();
  }
  const bool is_new = why.sentence != told.sentence;
  const std::string sentence = fmt::format("cannot be had as things are, and is kept in mind: {}", why.sentence);
  const Datum detail = failure_to_datum(why);
  if (is_new) co_await goal_.tell_progress(goal, "running", detail, "result", sentence);
  co_await await_change();
  co_return why;
}

// A search moves other objects about and takes minutes. Another would end the same way while nobody else has done
// anything, so that the arm rests.
Task<void> GoalLoop::await_sight(std::int64_t goal, Failure missing) {
  const std::vector<std::string> names = names_of_missing(missing);
  const Datum who = told_missing(names);
  const std::string sentence =
      missing.sentence + ", and is kept in mind: the arm rests until it shows, or something else was moved";
  co_await goal_.tell_progress(goal, "running", who, "missing", sentence);
  const Sightings& sightings = surroundings_.scene().sightings();
  const SeenPlaces before(sightings, options_.gripper.mark);
  std::string news;
  while (news.empty() && !vigil_.interrupted()) {
    for (const std::string& name : names) {
      // Eyes that do not answer, or show nothing, are waited for too.
      const Result<bool> found = co_await eyes_.find(name);
      const Result<void> looked = co_await eyes_.fresh_look();
      const bool shows = found && looked && sightings.recent(name, 2);
      if (shows) news = missing_shows;
    }
    const std::optional<std::string> moved = before.moved(sightings);
    if (news.empty() && moved) news = *moved + " was moved: what is missing is looked for again";
    if (news.empty()) co_await sleep(context_.executor, missing_pause);
  }
  const Datum nothing;
  if (!news.empty()) co_await goal_.tell_progress(goal, "running", nothing, "missing", news);
}

Task<void> GoalLoop::await_change() {
  const Time deadline = context_.executor.now() + hopeless_pause;
  const Facts before = surroundings_.beliefs();
  while (context_.executor.now() < deadline && surroundings_.beliefs() == before && !vigil_.interrupted()) {
    co_await sleep(context_.executor, watch_pause);
  }
}

}  // namespace pizarra::coordinator
