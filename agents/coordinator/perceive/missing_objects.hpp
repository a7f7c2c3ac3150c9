#pragma once

// Objects that are looked for and not seen, as the failure `missing-object`: its subject is the name, or the list of
// the names.
//
//   co_return std::unexpected(missing_objects({"circle"}));
//   names_of_missing(planned.error());                     // {"circle"}

#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::coordinator {

// At least one name.
Failure missing_objects(const std::vector<std::string>& names);
std::vector<std::string> names_of_missing(const Failure& failure);

}  // namespace pizarra::coordinator
