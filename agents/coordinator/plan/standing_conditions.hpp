#pragma once

// The conditions that must go on holding during an operation, so that it makes sense to finish it. The operation's own
// expected effects are no differences: its preconditions count until it commits itself (`close` or `release`), what the
// rest of the plan needs counts throughout.
//
//   conditions.begin(operation, needed_after);
//   Result<void> fine = conditions.check(beliefs);      // before every motion

#include "agents/coordinator/plan/ground_operation.hpp"
#include "agents/coordinator/plan/interruption.hpp"
#include "lisp/result.hpp"

namespace pizarra::coordinator {

class StandingConditions {
 public:
  // It outlives them.
  explicit StandingConditions(const Interruption& interruption) : interruption_(interruption) {}

  // `needed_after`: what must hold once it is done, for the rest of the plan.
  void begin(const GroundOperation& operation, const Facts& needed_after);
  // Between operations: nothing has to hold.
  void rest() {
    preconditions_.clear();
    throughout_.clear();
  }
  void commit() { committed_ = true; }

  // Failures: interrupted; difference, with the list of facts that ceased to hold as the subject.
  Result<void> check(const Facts& beliefs) const;

 private:
  const Interruption& interruption_;
  Facts preconditions_;
  Facts throughout_;
  bool committed_ = false;
};

}  // namespace pizarra::coordinator
