#pragma once

// A domain: the types, predicates and operators of a task, and how it is perceived and carried out, from one file.
//
//   (domain blocks
//     (types OBJECT)
//     (predicates (on (upper OBJECT) (lower OBJECT)) (clear (ob OBJECT)) (arm-empty) ...)
//     (objects (place-1 PLACE) ...)              ; what is there whatever is seen
//     (facts (free place-1) ...)                 ; what holds at the beginning whatever is seen
//     (operator PICK-UP
//       (params (<ob1> OBJECT))
//       (preconds (clear <ob1>) (on-table <ob1>) (arm-empty))
//       (effects (holding <ob1>) (del (clear <ob1>)) ...))
//     (extends "other.scm") (without NAME ...)   ; a variant of another domain: domain_extension.hpp
//     (perception ...)                           ; these two are other modules' business
//     (micro-tasks ...))
//
// Types, predicates, params and effects are checked against each other; what is wrong is one report with places.
//
//   Result<Domain> domain = read_domain_file("domains/blocks.scm");
//   domain->operators[0].preconds[0];             // (clear ?ob1)

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra::forms {

// A name and its type: an argument of a predicate, a parameter `?ob1` of an operator, an object.
struct TypedName {
  std::string name;
  std::string type;
  bool operator==(const TypedName&) const = default;
};

struct Predicate {
  std::string name;
  std::vector<TypedName> arguments;
};

// The thesis' `<ob1>` is the variable `?ob1` here, so that facts are patterns for match() and substitute().
struct Operator {
  std::string name;
  std::vector<TypedName> params;
  std::vector<Datum> preconds;
  std::vector<Datum> adds;
  std::vector<Datum> deletes;
};

struct Domain {
  std::string name;
  std::vector<std::string> types;
  std::vector<Predicate> predicates;
  std::vector<TypedName> objects;
  std::vector<Datum> facts;
  std::vector<Operator> operators;
  // The forms `(perception ...)` and `(micro-tasks ...)` as written; `()` where there is none.
  Datum perception;
  Datum micro_tasks;
  // Where they stand, for Source::failure_at: the path to the form.
  std::vector<std::size_t> perception_path;
  std::vector<std::size_t> micro_tasks_path;
  Source source;

  const Predicate* find_predicate(std::string_view predicate) const;
  const Operator* find_operator(std::string_view operator_name) const;
};

// Failures: the reader's, malformed, repeated, unknown-section, unknown-type, unknown-predicate, unknown-object,
// unknown-variable, wrong-arity, wrong-type, contradictory-effect, too-many (over 1000 in a section, over 100 in a part
// of an operator).
Result<Domain> read_domain(std::string_view text, std::string file);
Result<Domain> read_domain_file(const std::string& path);
Result<Domain> domain_from_source(Source source);

// An operator in the thesis' syntax again: (operator NAME (params (<ob1> OBJECT)) (preconds ...) (effects ... (del
// ...))).
Datum operator_form(const Operator& from);

}  // namespace pizarra::forms
