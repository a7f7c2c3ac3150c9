#pragma once

// One domain file with all its meaning: operators to plan with, rules to perceive by, micro-tasks to act by.
//
//   Result<TaskDomain> domain = TaskDomain::read("domains/blocks.scm");
//   Result<GroundOperation> operation = domain->ground(list("STACK"_sym, "circle"_sym, "square"_sym));

#include "agents/coordinator/plan/ground_operation.hpp"
#include "blackboard/relation.hpp"
#include "lisp/forms/domain.hpp"
#include "lisp/forms/micro_tasks.hpp"
#include "lisp/forms/perception.hpp"

namespace pizarra::coordinator {

class TaskDomain {
 public:
  // Failures: those of the three languages, missing-constant where perception says not how big a cube is, and
  // unknown-type where what it sees has no type of the domain; all in one report, once the operators are right.
  static Result<TaskDomain> read(const std::string& file);

  const forms::Domain& domain() const { return domain_; }
  const forms::Perception& perception() const { return perception_; }
  const forms::MicroTasks& micro_tasks() const { return micro_tasks_; }
  // Of the largest cubes, and of one.
  double cube_mm() const { return cube_mm_; }
  double edge_mm(std::string_view name) const;
  // The edge of a cube that is about as wide as a closed gripper says; none where no cube is.
  std::optional<double> edge_like(double opening_mm) const;
  // The cell's cubes, in place of those that the domain was written for.
  void use_cubes(double cube_mm, forms::EdgesMm edges_mm = {});

  // The objects that a goal names and the eyes must see: all but the domain's own.
  std::vector<std::string> objects_in(const std::vector<Datum>& goal) const;
  // Failures: unknown-operator, wrong-arity.
  Result<GroundOperation> ground(const Datum& operation) const;
  // The predicates as relations, every argument key.
  std::vector<Relation> relations() const;
  // Where a named place of the table is: (spot NAME X Y) of the perception section.
  const Datum* named_place(std::string_view name) const;
  // All of them.
  std::vector<const Datum*> named_places() const;

 private:
  forms::Domain domain_;
  forms::Perception perception_;
  forms::MicroTasks micro_tasks_;
  double cube_mm_ = 0;
  forms::EdgesMm edges_mm_;
};

}  // namespace pizarra::coordinator
