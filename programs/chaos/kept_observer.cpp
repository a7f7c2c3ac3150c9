#include "programs/chaos/kept_observer.hpp"

#include <fmt/format.h>
#include <utility>

#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

void KeptObserver::check_marks() const {
  for (const std::int64_t mark : marks_) {
    if (!facts_of(cell_.board(), list("chaos-mark"_sym, mark)).empty()) continue;
    unsafe_(fmt::format("the board lost mark {}, which it had said it keeps", mark));
  }
}

void KeptObserver::look() {
  look_at_goals();
  look_at_plan();
}

// The coordinator tells a goal's state with the goal, or after it. Without the goal nobody can go on with it.
void KeptObserver::look_at_goals() {
  for (const Datum& state : facts_of(cell_.board(), "(goal-state ? ? ?)")) {
    const bool is_kept = !facts_of(cell_.board(), list("goal"_sym, state[1], "?"_sym)).empty();
    if (is_kept || !goals_not_kept_.insert(state[1].integer()).second) continue;
    unsafe_(fmt::format("the board does not keep goal {}, whose state is told", state[1].integer()));
  }
}

// The planner has the board keep a plan before it tells of it. A plan that the disk has no space for is carried out all
// the same.
void KeptObserver::look_at_plan() {
  const simulated::SimulatedDisk& disk = cell_.disk();
  disk_failed_ = disk_failed_ || disk.fails() || disk.free_bytes() < disk.plenty / 2;
  const bool is_told_of = !facts_of(cell_.board(), "(planner planned ?)").empty();
  const bool was_kept = std::exchange(plan_is_kept_, !is_told_of || !facts_of(cell_.board(), "(plan ? ?)").empty());
  if (was_kept && !plan_is_kept_ && !disk_failed_) unsafe_("the board does not keep the plan that the planner has");
}

}  // namespace pizarra::chaos
