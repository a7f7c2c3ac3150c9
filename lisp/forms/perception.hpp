#pragma once

// A domain's perception section at work: measurements in, predicates out. The language is described in
// lisp/modules/pizarra/perception.scm.
//
//   Result<Perception> perception = Perception::read(source, {{"on", 2}, {"clear", 1}});
//   Result<std::vector<Datum>> facts = perception->perceive(measured, believed);

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra::forms {

// Names with their number of arguments.
using Arities = std::vector<std::pair<std::string, std::size_t>>;

// The edge of each known cube, by its name.
using EdgesMm = std::map<std::string, double, std::less<>>;

// ((NAME ARITY) ...), as the Scheme modules take them.
Datum arities_to_datum(const Arities& arities);

class Perception {
 public:
  // From a domain file whose predicates are given. Failures: malformed, missing-section, wrong-arity,
  // unbound-variable, unknown-constant; all of them in one report.
  static Result<Perception> read(const Source& domain, const Arities& predicates);

  // The facts that the rules find in what is measured, given what was believed before. Failure: too-much-work, whose
  // subject is the head of the rule that goes beyond what one look may take.
  Result<std::vector<Datum>> perceive(const std::vector<Datum>& measured, const std::vector<Datum>& believed) const;

  // The number under which the Scheme modules know the section.
  const Datum& section() const { return number_; }
  // The type of whatever the eyes can name.
  const std::string& sees() const { return sees_; }
  std::optional<double> constant(std::string_view name) const;
  // In place of what the section says of a constant that it has.
  void set_constant(std::string_view name, double value);
  // Has the rules know the edge of each of these cubes, (edge NAME MM).
  void set_edges(const EdgesMm& edges);
  // Facts that always hold, such as (spot place-1 450 -200).
  const std::vector<Datum>& facts() const { return facts_; }

 private:
  void keep(Datum section);

  Datum section_;
  Datum number_;
  std::string sees_;
  std::map<std::string, double, std::less<>> constants_;
  std::vector<Datum> facts_;
};

// The facts that the rules found, (ok (FACT ...)), or their failure.
Result<std::vector<Datum>> found_facts(const Datum& outcome);

}  // namespace pizarra::forms
