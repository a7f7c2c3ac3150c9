#include "agents/coordinator/pursue/kept_goal.hpp"

#include <fmt/format.h>

#include "agents/coordinator/geometry/seen_places.hpp"
#include "agents/coordinator/perceive/missing_objects.hpp"
#include "agents/coordinator/pursue/goal_state.hpp"
#include "lisp/forms/goal_formula.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration watch_pause = 300ms;
// How long nothing is tried of a kept goal that cannot be had as things are.
constexpr Duration hopeless_pause = 10s;

}  // namespace

// It ends only when another goal, or none, is wanted.
Task<Result<void>> KeptGoal::keep(Goal goal, StagedGoal staged) {
  const Datum nothing;
  Failure told;
  bool holds = false;
  while (true) {
    const Result<void> done = co_await pursuit_.run(goal, staged);
    if (interruption_.raised()) co_return interruption_.failure();
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
    while (holds && !interruption_.raised()) {
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

Task<Failure> KeptGoal::keep_in_mind(std::int64_t goal, Failure why, Failure told) {
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
Task<void> KeptGoal::await_sight(std::int64_t goal, Failure missing) {
  const std::vector<std::string> names = names_of_missing(missing);
  const Datum who = told_missing(names);
  const std::string sentence =
      missing.sentence + ", and is kept in mind: the arm rests until it shows, or something else was moved";
  co_await goal_.tell_progress(goal, "running", who, "missing", sentence);
  const Sightings& sightings = surroundings_.scene().sightings();
  const SeenPlaces before(sightings, options_.gripper.mark);
  std::string news;
  while (news.empty() && !interruption_.raised()) {
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

Task<void> KeptGoal::await_change() {
  const Time deadline = context_.executor.now() + hopeless_pause;
  const Facts before = surroundings_.beliefs();
  while (context_.executor.now() < deadline && surroundings_.beliefs() == before && !interruption_.raised()) {
    co_await sleep(context_.executor, watch_pause);
  }
}

}  // namespace pizarra::coordinator
