#pragma once

// A domain's micro-tasks section: which primitive motions an operation is made of. The language is described in
// lisp/modules/pizarra/micro-tasks.scm.
//
//   Result<MicroTasks> tasks = MicroTasks::read(source, {{"PICK-UP", 1}}, {{"raise", 0}, {"align", 1}});
//   Result<std::vector<Datum>> steps = tasks->expand(operation);     // (raise) (align circle) ...

#include "lisp/perception.hpp"

namespace pizarra {

class MicroTasks {
 public:
  // From a domain file with these operators, for an executor that knows these primitives. Failures: malformed,
  // missing-section, missing-task, unknown-step, unknown-parameter, wrong-arity, defined-twice; all in one report.
  static Result<MicroTasks> read(const Source& domain, const Arities& operators, const Arities& primitives);

  // Failure: missing-task.
  Result<std::vector<Datum>> expand(const Datum& operation) const;

 private:
  Datum section_;
};

}  // namespace pizarra
