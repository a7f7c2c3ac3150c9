#pragma once

// Planning tasks as people write them: PDDL (:strips :typing :negative-preconditions :equality :action-costs), the
// thesis' operator and fact files, or one of our domain files with a fact file. All become the same two forms:
//
//   (domain NAME ((TYPE PARENT) ...) ((CONSTANT TYPE) ...) ((PREDICATE TYPE ...) ...) ((FUNCTION TYPE ...) ...)
//     ((OPERATOR ((?VARIABLE TYPE) ...) (FACT ...) (ABSENT-FACT ...) ((= A B) | (differ A B) ...)
//        (ADD ...) (DELETE ...) (COST ...)) ...)
//     (FACT ...))
//   (problem ((OBJECT TYPE) ...) (FACT ...) (((FUNCTION ARGUMENT ...) VALUE) ...) (GOAL ...) (ABSENT-GOAL ...)
//     cost|none)
//
// The language is told by the first form: (define ...), (operator ...), (domain ...).
//
//   const Result<Source> domain = read_planning_source_file("domain.pddl");
//   const Result<Source> problem = read_planning_source_file("problem.pddl");
//   const Result<PlanningFiles> files = read_planning_files(*domain, *problem);

#include <optional>

#include "lisp/reader.hpp"

namespace pizarra::forms {

enum class PlanningLanguage : std::uint8_t { pddl, operators, domain_file };

struct PlanningDomain {
  PlanningLanguage language = PlanningLanguage::pddl;
  Datum form;
  // The thesis' operators, of which only facts tell whether the objects exist.
  std::optional<Source> operators = {};
};

// At most 4 MiB and 500 000 elements. PDDL's names come in lower case.
Result<Source> read_planning_source(std::string_view text, std::string file);
Result<Source> read_planning_source_file(const std::string& path);

// Failures, all of the files in one report: the reader's, malformed, repeated, unknown-section, unknown-requirement,
// unknown-type, unknown-predicate, unknown-function, unknown-object, unknown-variable, wrong-arity, wrong-type,
// wrong-domain, not-ground, contradictory, bad-number, unsupported (PDDL that is not understood), too-many; and
// wrong-file where a file holds something else altogether.
struct PlanningFiles {
  PlanningDomain domain;
  Datum problem;
};
Result<PlanningFiles> read_planning_files(const Source& domain, const Source& problem);

// One after another. Operators that are wrong are told together with what in them does not fit the `facts`, and
// operators that do not fit together with what is wrong in the facts.
Result<PlanningDomain> read_planning_domain(const Source& source, const Source* facts = nullptr);
Result<Datum> read_planning_problem(const Source& source, const PlanningDomain& domain);
// The problem's faults, as far as its domain, which is wrong too, can be understood.
Result<void> check_planning_problem(const Source& source, const Source& domain);

}  // namespace pizarra::forms
