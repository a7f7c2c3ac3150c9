#pragma once

// `check` for planning files: PDDL, and the thesis' operators and facts. Problems and facts are checked against the
// domain that was checked last, also where that is wrong.
//
//   PlanningCheck check;
//   if (PlanningCheck::knows(*source)) const Result<std::string> said = check.check(*source, nullptr);

#include <optional>

#include "lisp/forms/planning_files.hpp"

namespace pizarra::programs {

class PlanningCheck {
 public:
  // Whether the first form is one of those languages' (a cell's domain file is not).
  static bool knows(const Source& source);

  // What the file holds, in a few words. Failures: the languages', and no-domain. `next` is the file behind it, if any:
  // where those are facts, they tell the objects that operators may name.
  Result<std::string> check(const Source& source, const Source* next);
  // A file that problems and facts may belong to, without a word about it.
  Result<void> use_domain(const std::string& path);

 private:
  Result<std::string> check_domain(const Source& source, const Source* next);

  std::optional<forms::PlanningDomain> domain_;
  std::optional<Source> wrong_domain_;
};

}  // namespace pizarra::programs
