#pragma once

// The conditions that must go on holding during an operation, so that it makes sense to finish it. The operation's own
// expected effects are no differences: its preconditions count until it commits itself (`close` or `release`), what the
// rest of the plan needs counts throughout.
//
//   vigil.begin(operation, needed_after);
//   Result<void> fine = vigil.check(beliefs);      // before every motion

#include "agents/coordinator/plan/ground_operation.hpp"
#include "lisp/result.hpp"

namespace pizarra::coordinator {

class Vigil {
 public:
  // `needed_after`: what must hold once it is done, for the rest of the plan.
  void begin(const GroundOperation& operation, const Facts& needed_after);
  // Between operations: nothing has to hold.
  void rest() {
    preconditions_.clear();
    throughout_.clear();
  }
  void commit() { committed_ = true; }
  // The goal was replaced or cancelled: whatever is being done ends at the next check.
  void interrupt() { interrupted_ = true; }
  void clear_interrupt() { interrupted_ = false; }
  bool interrupted() const { return interrupted_; }

  // Failures: interrupted; difference, with the list of facts that ceased to hold as the subject.
  Result<void> check(const Facts& beliefs) const;

 private:
  Facts preconditions_;
  Facts throughout_;
  bool committed_ = false;
  bool interrupted_ = false;
};

}  // namespace pizarra::coordinator
