#include "agents/vision/objects/renames.hpp"

#include <algorithm>

#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {

std::string name_now(const Renames& renames, const std::string& name) {
  const auto was = std::ranges::find_if(renames, [&](const auto& entry) { return same_name(entry.first, name); });
  return was == renames.end() ? name : was->second;
}

}  // namespace pizarra::vision
