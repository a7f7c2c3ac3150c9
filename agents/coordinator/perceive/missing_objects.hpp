#pragma once

// Objects that are looked for and not seen, as the failure `missing-object`: its subject is the name, or the list of
// the names.
//
//   co_return std::unexpected(missing_objects({"circle"}));
//   names_of_missing(planned.error());                     // {"circle"}

#include <string>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra::coordinator {

// At least one name.
Failure missing_objects(const std::vector<std::string>& names);
std::vector<std::string> names_of_missing(const Failure& failure);

// How often one looks for them, and what is told when one shows.
inline constexpr Duration missing_pause = 1s;
inline constexpr const char* missing_shows = "what was missing is seen: going on";

}  // namespace pizarra::coordinator
