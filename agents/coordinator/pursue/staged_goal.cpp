#include "agents/coordinator/pursue/staged_goal.hpp"

#include <chrono>

namespace pizarra::coordinator {

StagedGoal staged_goal_of(const std::vector<Datum>& goal) {
  StagedGoal staged;
  std::vector<Datum> together;
  for (const Datum& form : goal) {
    const std::span<const Datum> parts = form.items();
    if (form.is_form("wait")) {
      staged.patience = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(form[1].number()));
    } else if (form.is_form("then")) {
      for (const Datum& stage : parts.subspan(1)) {
        const bool joined = stage.is_form("and");
        staged.stages.push_back(joined ? std::vector<Datum>(stage.items().begin() + 1, stage.items().end())
                                       : std::vector<Datum>{stage});
      }
    } else if (form.is_form("keep")) {
      staged.keeps = true;
      together.insert(together.end(), parts.begin() + 1, parts.end());
    } else {
      together.push_back(form);
    }
  }
  if (!together.empty()) staged.stages.push_back(std::move(together));
  return staged;
}

}  // namespace pizarra::coordinator
