#include "lisp/forms/micro_tasks.hpp"

#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

Result<MicroTasks> MicroTasks::read(const Source& domain, const Arities& operators, const Motions& motions) {
  std::vector<Datum> aimed;
  for (const std::string& name : motions.aimed) aimed.push_back(Datum::symbol(name));
  const std::vector<Datum> more{arities_to_datum(operators), arities_to_datum(motions.primitives),
                                Datum::list(std::move(aimed)), arities_to_datum(motions.targets)};
  const Result<Datum> section = guile::interpret(domain, "micro-tasks", more);
  if (!section) return fail(section);
  MicroTasks tasks;
  tasks.section_ = *section;
  return tasks;
}

Result<std::vector<Datum>> MicroTasks::expand(const Datum& operation) const {
  const std::vector<Datum> arguments{section_, operation};
  const Result<Datum> steps = guile::call_scheme("micro-tasks", "expand", arguments);
  if (!steps) return fail(steps);
  if (steps->size() == 0) return fail("missing-task", "the domain has no micro-task for this operation", operation);
  return std::vector<Datum>(steps->items().begin(), steps->items().end());
}

}  // namespace pizarra::forms
