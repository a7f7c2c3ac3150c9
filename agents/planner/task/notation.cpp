#include "agents/planner/task/notation.hpp"

#include <fmt/format.h>

#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

Datum with_angles(const Datum& datum) {
  if (is_variable(datum)) return Datum::symbol(fmt::format("<{}>", datum.text().substr(1)));
  if (!datum.is_list()) return datum;
  std::vector<Datum> items;
  for (const Datum& item : datum.items()) items.push_back(with_angles(item));
  return Datum::list(std::move(items));
}

std::string written(const PlanningTask& task, const Datum& datum) {
  return write(task.angles ? with_angles(datum) : datum);
}

}  // namespace pizarra::planner
