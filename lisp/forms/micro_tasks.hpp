#pragma once

// A domain's micro-tasks section: which primitive motions an operation is made of. The language is described in
// lisp/modules/pizarra/micro-tasks.scm.
//
//   const Motions motions{.primitives = {{"raise", 0}, {"align", 1}}, .aimed = {"align"}, .targets = {{"on-top", 2}}};
//   Result<MicroTasks> tasks = MicroTasks::read(source, {{"PICK-UP", 1}}, motions);
//   Result<std::vector<Datum>> steps = tasks->expand(operation);     // (raise) (align circle) ...

#include "lisp/forms/perception.hpp"

namespace pizarra::forms {

// The abilities of an executor: its primitives, those of them that take a target where others take an object, and the
// forms of target that it knows.
struct Motions {
  Arities primitives;
  std::vector<std::string> aimed;
  Arities targets;
};

class MicroTasks {
 public:
  // From a domain file with these operators, for an executor of these motions. Failures: malformed, missing-section,
  // missing-task, unknown-step, unknown-target, unknown-parameter, wrong-argument, wrong-arity, defined-twice,
  // is-a-primitive; all in one report.
  static Result<MicroTasks> read(const Source& domain, const Arities& operators, const Motions& motions);

  // Failure: missing-task.
  Result<std::vector<Datum>> expand(const Datum& operation) const;

 private:
  Datum section_;
};

}  // namespace pizarra::forms
