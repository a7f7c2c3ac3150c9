#pragma once

// Why a goal does not hold as things are, and what would bring it about: the answer to `why-not`. Nothing is changed,
// and the plan in use goes on.
//
//   WhyNot why_not(options, domain, surroundings, eyes, planning);
//   co_await why_not.tell(goal);
//   // "(on circle triangle) does not hold, (on-table circle) and (on square triangle) do",
//   // "a plan leads there: (UNSTACK square triangle) (PUT-DOWN square) (PICK-UP circle) (STACK circle triangle)"

#include "agents/coordinator/perceive/eyes.hpp"
#include "agents/coordinator/pursue/planning.hpp"

namespace pizarra::coordinator {

class WhyNot {
 public:
  WhyNot(const CoordinatorOptions& options, const TaskDomain& domain, const Surroundings& surroundings, Eyes& eyes,
         Planning& planning)
      : options_(options), domain_(domain), surroundings_(surroundings), eyes_(eyes), planning_(planning) {}

  // Sentences about a checked goal, of stages one after another. Failures: those of the eyes, which look first.
  Task<Result<std::vector<std::string>>> tell(std::vector<Datum> goal);

 private:
  Task<Result<void>> look();
  std::string unmet(const Datum& part) const;
  // The way to a stage: who is missing, the plan, or why there is none.
  Task<std::string> way_to(std::vector<Datum> stage);

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const Surroundings& surroundings_;
  Eyes& eyes_;
  Planning& planning_;
};

}  // namespace pizarra::coordinator
