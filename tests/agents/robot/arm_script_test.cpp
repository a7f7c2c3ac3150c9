#include "agents/robot/arm_script.hpp"

#include <gtest/gtest.h>

#include "agents/robot/tool_path.hpp"
#include "drivers/arm/arm_file.hpp"

namespace pizarra::robot {
namespace {

const arm::ArmModel& crs_f3 = arm::crs_f3();
const arm::Joints beside_the_table{0, -40, -80, 0, -60, 0, 2500};

Eigen::Vector3d grip_centre(const arm::Joints& joints) { return arm::forward(crs_f3, joints).translation(); }

Failure failure_of(std::string_view text, const ArmVariables& variables = {}) {
  const Result<std::vector<arm::Joints>> waypoints = script_waypoints(crs_f3, text, beside_the_table, variables);
  return waypoints ? Failure{} : waypoints.error();
}

TEST(ArmScript, MovesStraightToCoordinates) {
  const auto waypoints = script_waypoints(crs_f3, "(move 450 -100 200) (move 450 100 200)", beside_the_table, {});
  ASSERT_TRUE(waypoints) << describe(waypoints.error());
  EXPECT_LT((grip_centre(waypoints->back()) - Eigen::Vector3d(450, 100, 200)).norm(), 1e-6);
  EXPECT_GT(waypoints->size(), 40u);
}

TEST(ArmScript, CircleRunsThroughItsThreePointsAndCloses) {
  const Eigen::Vector3d corners[] = {{450, 0, 200}, {420, 30, 200}, {390, 0, 200}};
  const auto waypoints =
      script_waypoints(crs_f3, "(circle (450 0 200) (420 30 200) (390 0 200))", beside_the_table, {});
  ASSERT_TRUE(waypoints) << describe(waypoints.error());
  EXPECT_LT((grip_centre(waypoints->back()) - corners[0]).norm(), 1e-6);
  for (const Eigen::Vector3d& corner : corners) {
    double nearest = 1e9;
    for (const arm::Joints& joints : *waypoints) nearest = std::min(nearest, (grip_centre(joints) - corner).norm());
    EXPECT_LT(nearest, ToolPath::step_mm / 2) << corner.transpose();
  }
  double furthest_left = 0;
  for (const arm::Joints& joints : *waypoints) {
    const Eigen::Vector3d off = grip_centre(joints) - Eigen::Vector3d(420, 0, 200);
    if (off.norm() < 35) furthest_left = std::min(furthest_left, off.y());
  }
  EXPECT_NEAR(furthest_left, -30, 0.06) << "the half that no point was given on is driven too";
}

TEST(ArmScript, ArcEndsAtItsThirdPoint) {
  const auto waypoints = script_waypoints(crs_f3, "(arc (450 0 200) (420 30 200) (390 0 200))", beside_the_table, {});
  ASSERT_TRUE(waypoints);
  EXPECT_LT((grip_centre(waypoints->back()) - Eigen::Vector3d(390, 0, 200)).norm(), 1e-6);
}

TEST(ArmScript, PathLeadsThroughLearnedVariables) {
  const ArmVariables variables{{"a", {10, -30, -70, 0, -80, 5, 2500}}, {"b", {20, -30, -70, 0, -80, 5, 2500}}};
  const auto waypoints = script_waypoints(crs_f3, "(path a b a)", beside_the_table, variables);
  ASSERT_TRUE(waypoints);
  EXPECT_EQ(*waypoints, (std::vector<arm::Joints>{variables.at("a"), variables.at("b"), variables.at("a")}));
}

TEST(ArmScript, ControllerSpellingMeansTheSame) {
  const ArmVariables variables{
      {"p1", beside_the_table}, {"p2", {5, -40, -80, 0, -60, 0, 2500}}, {"p3", {5, -45, -80, 0, -55, 0, 2500}}};
  const auto lisp = script_waypoints(crs_f3, "(circle p1 p2 p3)\n(move 450 0 200)", beside_the_table, variables);
  const auto script = script_waypoints(crs_f3, "CIRCLE p1, p2, p3\nMOVE 450, 0, 200\n", beside_the_table, variables);
  ASSERT_TRUE(lisp) << describe(lisp.error());
  ASSERT_TRUE(script) << describe(script.error());
  EXPECT_EQ(*lisp, *script);
}

TEST(ArmScript, ErrorsNameTheirPlace) {
  EXPECT_EQ(failure_of("(cirle a b c)").symbol, "bad-action");
  EXPECT_NE(failure_of("(cirle a b c)").sentence.find("circle"), std::string::npos);
  const Failure second = failure_of("(move 450 0 200)\n(move 4000 0 200)");
  EXPECT_EQ(second.symbol, "unreachable");
  EXPECT_NE(second.place.find(":2:"), std::string::npos) << second.place;
  EXPECT_EQ(failure_of("").symbol, "bad-action");
  EXPECT_EQ(failure_of("(move here)").symbol, "unknown-variable");
  EXPECT_EQ(failure_of("(move 1 2)").symbol, "bad-action");
  EXPECT_EQ(failure_of("(circle (450 0 200) (440 0 200) (430 0 200))").symbol, "bad-action");
  EXPECT_EQ(failure_of("(circle (450 0 200) (450 0 200) (430 0 200))").symbol, "bad-action");
  EXPECT_EQ(failure_of("(move 1e308 1e308 0)").symbol, "unreachable");
  EXPECT_FALSE(failure_of("(move 450 0 200").symbol.empty());
  EXPECT_FALSE(failure_of(std::string(5000, ' ')).symbol.empty());
}

TEST(ArmScript, WaysWithoutEndAreRefused) {
  std::string text;
  for (int i = 0; i < 32; ++i)
    text += i % 2 == 0 ? "(circle (450 -90 200) (450 90 200) (360 0 200))" : "(move 450 0 60)";
  EXPECT_EQ(failure_of(text).symbol, "too-long");
  EXPECT_EQ(failure_of(text + "(move 450 0 200)").symbol, "bad-action");
}

}  // namespace
}  // namespace pizarra::robot
