#pragma once

// What the parts of the loop compute, each alone on one thread: the eyes for a look, the planner for a plan and for the
// choice of the next operation.
//
//   const std::optional<double> look_s = look_seconds(8);
//   const PlanSeconds planner_s = plan_seconds(8, 4);

#include <optional>

namespace pizarra::bench {

// More tags do not fit into the images.
inline constexpr int most_looked_at = 12;

// The median of the eyes' time for a pair of images with so many tags that move a little from one pair to the next.
// None where there are too many, or where the eyes lose one.
std::optional<double> look_seconds(int objects);

struct PlanSeconds {
  double plan = 0;    // a first plan
  double choose = 0;  // which operation is next, by what is believed
};

// Medians, for a tower of some of the cubes, which all stand on the table. Throws where no plan is found.
PlanSeconds plan_seconds(int objects, int tower);

}  // namespace pizarra::bench
