#include "drivers/arm/universal/move_script.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/kinematics.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::arm {

std::string move_script(const ArmModel& model, const std::vector<Leg>& legs, double speed, const Joints& from,
                        std::int32_t begun) {
  std::string text = fmt::format("def pizarra():\n  write_output_integer_register(24, {})\n", begun);
  Joints at = from;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Joints& to = legs[i].to;
    const double seconds = std::max(legs[i].seconds / speed, 1e-3);
    double way = 0;  // of the leading axis, or of the tool
    for (std::size_t axis = 0; axis < to.size(); ++axis) way = std::max(way, radians(std::abs(to[axis] - at[axis])));
    if (legs[i].straight) way = (forward(model, to).translation() - forward(model, at).translation()).norm() / 1000;
    const double v = way / seconds;
    text += fmt::format("  {}([{:.6f}, {:.6f}, {:.6f}, {:.6f}, {:.6f}, {:.6f}], a={:.4f}, v={:.4f}, r={})\n",
                        legs[i].straight ? "movel" : "movej", radians(to[0]), radians(to[1]), radians(to[2]),
                        radians(to[3]), radians(wrist_2_deg), radians(to[4]), std::max(4 * v, 0.01), std::max(v, 0.001),
                        i + 1 < legs.size() ? "0.001" : "0");
    at = to;
  }
  return text + fmt::format("  write_output_integer_register(24, {})\nend\n", begun + 1);
}

}  // namespace pizarra::arm
