#pragma once

// The objects that have other names now, all at once, so that two that exchange their names stay two.
//
//   name_now(renames, "circle");                      // "disc"

#include <map>
#include <string>

namespace pizarra::vision {

using Renames = std::map<std::string, std::string>;  // from the old name to the new one

// The present name of the object that had this one.
std::string name_now(const Renames& renames, const std::string& name);

}  // namespace pizarra::vision
