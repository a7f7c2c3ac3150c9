#pragma once

// Which name somebody probably meant.
//
//   nearest_name("sen", {"on", "seen"});     // "seen"

#include <string>
#include <string_view>
#include <vector>

namespace pizarra {

// The name with the smallest edit distance, the first of equals; empty when more than half of it would have to change.
std::string nearest_name(std::string_view wrong, const std::vector<std::string>& names);

}  // namespace pizarra
