#pragma once

// A goal as typed on the command line, checked before anything runs: the objects are the cubes of the cell file, which
// its person will teach by their names.

#include <string>
#include <vector>

#include "lisp/forms/cell_file.hpp"
#include "lisp/forms/goal.hpp"

namespace pizarra::programs {

// Whether anything was typed at all. Failure: malformed.
inline Result<void> check_typed_goal(const std::string& text) {
  if (text.find_first_not_of(" \t\r\n") != std::string::npos) return {};
  return fail("malformed", "nothing is typed: a goal is FACT, (and FACT ...) or several FACTs");
}

// The type of what the eyes can name, from the domain's perception section.
inline std::string seen_type(const forms::Domain& domain) {
  for (const Datum& part : domain.perception.items()) {
    if (part.is_form("sees") && part.size() == 2) return std::string(part[1].text());
  }
  return domain.types.empty() ? std::string() : domain.types.front();
}

inline Result<std::vector<Datum>> read_goal_for(const forms::Domain& domain, const std::string& text,
                                                const forms::CellDescription& cell) {
  const std::string type = seen_type(domain);
  std::vector<std::pair<std::string, std::string>> typed;
  for (const forms::CubePlacement& cube : cell.cubes) typed.emplace_back(cube.name, type);
  return forms::read_goal(domain, text, typed);
}

}  // namespace pizarra::programs
