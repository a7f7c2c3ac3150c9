#include "agents/coordinator/pursue/staged_pursuit.hpp"

#include <fmt/format.h>

#include "agents/coordinator/perceive/missing_objects.hpp"
#include "agents/coordinator/pursue/goal_state.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

Task<Result<void>> StagedPursuit::run(Goal goal, StagedGoal staged) {
  for (std::size_t i = goal.stage; i < staged.stages.size(); ++i) {
    const Goal stage{goal.number, staged.stages[i], i};
    const bool is_later = i > goal.stage;
    if (is_later) {
      std::string sentence = fmt::format("stage {} of {} holds; the next:", i, staged.stages.size());
      for (const Datum& form : staged.stages[i]) sentence += ' ' + write(form);
      plan_.forget();
      const Datum detail = told_in_stage(stage.stage, Datum());
      co_await goal_.tell_progress(goal.number, "running", detail, "goal", sentence);
    }
    const Result<void> done = co_await pursue_patiently(stage, staged.patience);
    if (!done) co_return done;
  }
  co_return Result<void>();
}

Task<Result<void>> StagedPursuit::pursue_patiently(Goal goal, Duration patience) {
  while (true) {
    const Result<void> done = co_await pursuit_.run(goal);
    const bool waits = !done && done.error().symbol == "missing-object" && patience > Duration::zero();
    if (!waits) co_return done;
    const Failure& missing = done.error();
    const Result<void> there = co_await await_missing(goal, missing, patience);
    if (!there) co_return there;
  }
}

Task<Result<void>> StagedPursuit::await_missing(Goal goal, Failure missing, Duration patience) {
  const std::vector<std::string> names = names_of_missing(missing);
  const double seconds = std::chrono::duration<double>(patience).count();
  const std::string sentence = fmt::format("{}: waiting {:g} s for it", missing.sentence, seconds);
  const Datum told = told_in_stage(goal.stage, told_missing(names));
  co_await goal_.tell_progress(goal.number, "running", told, "missing", sentence);
  const Time deadline = context_.executor.now() + patience;
  for (const std::string& name : names) {
    while (!surroundings_.scene().sightings().recent(name, 2)) {
      if (interruption_.raised()) co_return interruption_.failure();
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
  const Datum nothing = told_in_stage(goal.stage, Datum());
  const std::string seen = missing_shows;
  co_await goal_.tell_progress(goal.number, "running", nothing, "missing", seen);
  co_return Result<void>();
}

}  // namespace pizarra::coordinator
