#include "drivers/arm/arm_model.hpp"

#include <algorithm>
#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::arm {

std::string_view role_name(Role role) {
  constexpr std::array<std::string_view, 11> names{"turn", "shoulder", "elbow", "reach", "ahead", "across",
                                                   "lift", "roll",     "pitch", "spin",  "track"};
  return names[static_cast<std::size_t>(role)];
}

bool slides(Role role) {
  return role == Role::reach || role == Role::ahead || role == Role::across || role == Role::lift ||
         role == Role::track;
}

std::optional<std::size_t> ArmModel::axis_of(Role role) const {
  const auto found = std::ranges::find(axes, role, &Axis::role);
  if (found == axes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - axes.begin());
}

double ArmModel::elbow_to_wrist_mm() const { return std::hypot(forearm_mm, forearm_raise_mm); }

double ArmModel::forearm_bend_deg() const { return degrees(std::atan2(forearm_raise_mm, forearm_mm)); }

}  // namespace pizarra::arm
