#include "drivers/simulation/render/paint_order.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace pizarra::simulation {
namespace {

Solid cube_at(double x_mm, double y_mm, double z_mm, double yaw_deg) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(x_mm, y_mm, z_mm));
  pose.rotate(Eigen::AngleAxisd(yaw_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()));
  return make_box(pose, Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(30), Colour());
}

// Two planes part the lower cube from its neighbour, and the eye is on either side of one: neither hides the other.
TEST(PaintOrder, PaintsACubeOverTheOneItStandsOnThoughANeighbourTouchesBoth) {
  const std::vector<Solid> solids{cube_at(464.44, -148.56, 30, 4.936), cube_at(464.47, -148.55, 90, 4.33),
                                  cube_at(461, -86, 30, 0)};
  for (const Side side : {Side::left, Side::right}) {
    const Eye eye = make_eye(CameraConfig(), side);
    std::vector<SeenSolid> seen;
    for (const Solid& solid : solids) seen.push_back(see(eye, solid));
    const std::vector<std::size_t> order = paint_order(eye, solids, seen);
    ASSERT_EQ(order.size(), 3U);
    EXPECT_LT(std::ranges::find(order, 0U), std::ranges::find(order, 1U)) << static_cast<int>(side);
  }
}

}  // namespace
}  // namespace pizarra::simulation
