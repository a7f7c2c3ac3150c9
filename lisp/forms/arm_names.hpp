#pragma once

// The arms that come with the tree: arms/NAME.scm, described in drivers/arm/arm_file.hpp. A cell file names one.
//
//   shipped_arm_file(arm_called("up6"));        // the path of arms/motoman-up6.scm

#include <string>
#include <string_view>
#include <vector>

namespace pizarra::forms {

// Sorted.
std::vector<std::string> arm_names();
std::string shipped_arm_file(std::string_view name);

// The arm that a person means: a name or the last part of one ("up6" for motoman-up6); empty where there is none.
std::string arm_called(std::string_view name);

}  // namespace pizarra::forms
