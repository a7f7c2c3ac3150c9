#pragma once

// Why a goal does not hold as things are, and what would bring it about: the answer to `why-not`. Nothing is changed,
// and the plan in use goes on.
//
//   WhyNot why_not(options, domain, surroundings, eyes, planning);
//   co_await why_not.tell(goal);
//   // "(on circle triangle) does not hold, (on-table circle) and (on square triangle) do",
//   // "a plan leads there: (UNSTACK square triangle) (PUT-DOWN square) (PICK-UP circle) (STACK circle triangle)"
//
// Each stage is planned for from where the plan of the one before ends.

#include <optional>

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
  // Where a stage is planned from.
  struct Outset {
    Facts facts;
    enum class Kind { seen, after_plan, seen_without_plan } kind;  // the last: the stage before has no plan
  };
  // The way to a stage: who is missing, the plan, or why there is none.
  struct Way {
    std::string sentence;
    std::optional<Facts> end;  // what holds after the plan; none: there is no plan
  };
  static std::string title(std::size_t stage, std::size_t stages, const Outset& outset);
  std::string unmet(const Datum& part, const Outset& outset, const Way& way) const;
  Task<Way> way_to(std::vector<Datum> stage, Facts from);
  std::optional<Facts> end_of(const std::vector<Datum>& plan, Facts from) const;

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const Surroundings& surroundings_;
  Eyes& eyes_;
  Planning& planning_;
};

}  // namespace pizarra::coordinator
