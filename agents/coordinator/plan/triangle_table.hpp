#pragma once

// The triangle table of a plan: for each suffix of it, the facts that must hold for that suffix to reach the goal.
//
// The last suffix is empty and needs the goal itself. After every change of the facts the furthest suffix whose needs
// hold is the one to go on with: it skips what somebody else did, and repeats what was undone while the plan covers it.
//
//   TriangleTable table(plan, goal);
//   std::optional<std::size_t> next = table.furthest(facts);   // the operation to do; plan.size(): done; none: plan
//   anew

#include <optional>
#include <set>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::coordinator {

using Facts = std::set<Datum>;

// One operation with its variables replaced.
struct GroundOperation {
  Datum name;  // (STACK circle triangle)
  std::vector<Datum> preconditions;
  std::vector<Datum> adds;
  std::vector<Datum> deletes;
};

class TriangleTable {
 public:
  TriangleTable() : TriangleTable({}, {}) {}
  TriangleTable(std::vector<GroundOperation> plan, const std::vector<Datum>& goal);

  const std::vector<GroundOperation>& plan() const { return plan_; }
  // What must hold before operation `index`; index plan().size() is the goal.
  const Facts& needed(std::size_t index) const { return needed_[index]; }
  // What must stay true while operation `index` is done: what the rest needs and it does not itself provide or change.
  Facts kept_during(std::size_t index) const;
  std::optional<std::size_t> furthest(const Facts& facts) const;

 private:
  std::vector<GroundOperation> plan_;
  std::vector<Facts> needed_;
};

}  // namespace pizarra::coordinator
