#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "agents/robot/motion.hpp"
#include "blackboard/time/random.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/posture.hpp"
#include "lisp/forms/arm_names.hpp"
#include "lisp/reader.hpp"
#include "tests/campaign.hpp"

// The seventeen operations mean the same for every arm that comes with the tree.

namespace pizarra::robot {
namespace {

constexpr std::uint64_t seed = 4;

std::vector<arm::ArmModel> arms() {
  std::vector<arm::ArmModel> all;
  for (const std::string& name : forms::arm_names()) all.push_back(arm::shipped_arm(name).value());
  return all;
}

Result<Motion> planned(const arm::ArmModel& arm, const std::string& operation, const arm::Joints& from) {
  return plan_motion(arm, read_one(operation).value(), from, {});
}

// The tool down, somewhere around where work begins.
arm::Joints somewhere(const arm::ArmModel& arm, Random& random) {
  while (true) {
    arm::ToolPose pose = arm::forward(arm, arm.ready);
    pose.translation() += Eigen::Vector3d(random.uniform(-60, 60), random.uniform(-120, 120), random.uniform(-60, 20));
    const Result<arm::Joints> joints = arm::inverse(arm, pose, arm.ready);
    if (joints) return *joints;
  }
}

arm::Joints between(const arm::Joints& from, const arm::Joints& to, double part) {
  arm::Joints joints(from.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) joints[axis] = std::lerp(from[axis], to[axis], part);
  return joints;
}

// The furthest that the arm leaves the straight line to where it ends, and its tool's direction leaves that of the
// beginning, on the way and not only at its end.
struct Deviation {
  double mm = 0;
  double tilt = 0;
};
Deviation deviation(const arm::ArmModel& arm, const arm::Joints& from, const std::vector<arm::Joints>& waypoints) {
  const arm::ToolPose start = arm::forward(arm, from);
  const Eigen::Vector3d along = (arm::forward(arm, waypoints.back()).translation() - start.translation()).normalized();
  Deviation worst;
  arm::Joints before = from;
  for (const arm::Joints& to : waypoints) {
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      const arm::ToolPose pose = arm::forward(arm, between(before, to, part));
      const Eigen::Vector3d off = pose.translation() - start.translation();
      worst.mm = std::max(worst.mm, (off - off.dot(along) * along).norm());
      worst.tilt = std::max(worst.tilt, (pose.linear() - start.linear()).norm());
    }
    before = to;
  }
  return worst;
}

TEST(ArmsMotion, LinesAreStraightAllAlongAndKeepTheTool) {
  for (const arm::ArmModel& arm : arms()) {
    Random random(seed);
    int checked = 0;
    for (int i = 0; i < 60; ++i) {
      const arm::Joints from = somewhere(arm, random);
      for (const char* operation :
           {"(move-h right 37)", "(move-h left 20)", "(move-v up 23)", "(move-v down 31)", "(extend keep-height 25)",
            "(retract 18)", "(extend keep-distance 12)", "(extend keep-angle 15)"}) {
        const Result<Motion> motion = planned(arm, operation, from);
        if (!motion || motion->waypoints.empty()) continue;
        ++checked;
        const Deviation off = deviation(arm, from, motion->waypoints);
        EXPECT_LT(off.mm, 0.1) << arm.type << " " << operation << " seed " << seed << " case " << i;
        EXPECT_LT(off.tilt, 2e-3) << arm.type << " " << operation << " seed " << seed << " case " << i;
      }
    }
    EXPECT_GT(checked, 300) << arm.type;
  }
}

// Anywhere that the axes go, singular places and the ends of axes as often as others.
arm::Joints anywhere(const arm::ArmModel& arm, Random& random) {
  arm::Joints joints(arm.axes.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const arm::Range range = arm::range_of(arm, joints, axis);
    const double kind = random.uniform(0, 1);
    joints[axis] = random.uniform(range.low, range.high);
    if (kind < 0.05) joints[axis] = range.low;
    if (kind > 0.95) joints[axis] = range.high;
    const bool straight = kind > 0.4 && kind < 0.5;
    if (straight) joints[axis] = std::clamp(0.0, range.low, range.high);
  }
  return joints;
}

// Where the operation leads: of unit length, in the base frame.
Eigen::Vector3d direction(const arm::ArmModel& arm, std::string_view operation, const arm::Joints& from) {
  if (operation == "move-h right") return Eigen::Vector3d::UnitY();
  if (operation == "move-h left") return -Eigen::Vector3d::UnitY();
  if (operation == "move-v up" || operation == "extend keep-distance") return Eigen::Vector3d::UnitZ();
  if (operation == "move-v down") return -Eigen::Vector3d::UnitZ();
  const arm::Stretch stretch = arm::stretch_of(arm, from);
  if (operation == "extend keep-height") return stretch.ahead;
  if (operation == "retract") return -stretch.ahead;
  return (stretch.d_mm * stretch.ahead + stretch.h_mm * Eigen::Vector3d::UnitZ()).normalized();
}

// The furthest that the way leaves the line along `along`, seen at as many places between two waypoints.
double off_line_mm(const arm::ArmModel& arm, const arm::Joints& from, const Eigen::Vector3d& along,
                   const std::vector<arm::Joints>& waypoints) {
  constexpr int places = 12;
  const Eigen::Vector3d start = arm::forward(arm, from).translation();
  double worst = 0;
  const arm::Joints* before = &from;
  for (const arm::Joints& to : waypoints) {
    for (int place = 1; place <= places; ++place) {
      const arm::Joints joints = between(*before, to, static_cast<double>(place) / places);
      const Eigen::Vector3d off = arm::forward(arm, joints).translation() - start;
      worst = std::max(worst, (off - off.dot(along) * along).norm());
    }
    before = &to;
  }
  return worst;
}

TEST(ArmsMotion, LongLinesFromAnywhereAreStraightOrRefused) {
  const std::set<std::string> refusals{"unreachable", "joint-limit", "singular"};
  const int places = campaign(20, 80);
  for (const arm::ArmModel& arm : arms()) {
    Random random(seed);
    int checked = 0;
    for (int i = 0; i < places; ++i) {
      const arm::Joints from = anywhere(arm, random);
      const double mm = std::round(random.uniform(150, 300));
      for (const char* operation : {"move-h right", "move-h left", "move-v up", "move-v down", "extend keep-height",
                                    "extend keep-angle", "extend keep-distance", "retract"}) {
        const std::string asked = fmt::format("({} {})", operation, mm);
        const std::string which = fmt::format("{} {} seed {} case {}", arm.type, asked, seed, i);
        const Result<Motion> motion = planned(arm, asked, from);
        if (!motion) {
          EXPECT_TRUE(refusals.contains(motion.error().symbol)) << which << " " << motion.error().symbol;
          continue;
        }
        if (motion->waypoints.empty()) continue;
        ++checked;
        for (const arm::Joints& joints : motion->waypoints) ASSERT_TRUE(arm::check_limits(arm, joints)) << which;
        EXPECT_LT(off_line_mm(arm, from, direction(arm, operation, from), motion->waypoints), 0.1) << which;
      }
    }
    EXPECT_GT(checked, 5 * places / 2) << arm.type;
  }
}

TEST(ArmsMotion, FullyExtendedAndContractedArmsDoNotMove) {
  for (const arm::ArmModel& arm : arms()) {
    for (const char* operation : {"(extend keep-height 9000)", "(retract 9000)", "(extend keep-distance 9000)"}) {
      const Result<Motion> all = planned(arm, operation, arm.ready);
      ASSERT_TRUE(all) << arm.type << " " << operation;
      if (all->waypoints.empty()) continue;
      const Result<Motion> more = planned(arm, operation, all->waypoints.back());
      ASSERT_TRUE(more) << arm.type << " " << operation;
      EXPECT_TRUE(more->waypoints.empty()) << arm.type << " " << operation;
      EXPECT_TRUE(more->at_limit) << arm.type << " " << operation;
    }
  }
}

TEST(ArmsMotion, TurnsGoTheSameWayOnEveryArmToAHundredthOfADegree) {
  for (const arm::ArmModel& arm : arms()) {
    const Result<Motion> motion = planned(arm, "(turn right 10.004)", arm.ready);
    ASSERT_TRUE(motion) << arm.type << ": " << motion.error().sentence;
    const arm::Joints& there = motion->waypoints.back();
    const arm::ToolPose ready = arm::forward(arm, arm.ready);
    const arm::ToolPose turned =
        arm::ToolPose(Eigen::AngleAxisd(std::numbers::pi / 18, Eigen::Vector3d::UnitZ())) * ready;
    EXPECT_LT((arm::forward(arm, there).matrix() - turned.matrix()).norm(), 1e-6) << arm.type;
    const Eigen::Vector3d before = arm::forward(arm, arm.ready).translation();
    const Eigen::Vector3d after = arm::forward(arm, there).translation();
    EXPECT_GT(before.cross(after).z(), 0) << arm.type << ": right is towards y";
    const Result<Motion> back = planned(arm, "(turn-wrist left 10)", there);
    ASSERT_TRUE(back) << arm.type;
    const Eigen::Matrix3d fingers = arm::forward(arm, back->waypoints.back()).linear();
    EXPECT_LT((fingers - arm::forward(arm, arm.ready).linear()).norm(), 1e-9) << arm.type;
  }
}

TEST(ArmsMotion, AnArmThatNoAxisTurnsCarriesItsToolRoundOnTheSameArcAsFarAsItReaches) {
  const arm::ArmModel arm = arm::shipped_arm("gantry").value();
  const double radius = arm::forward(arm, arm.ready).translation().head<2>().norm();
  const Result<Motion> motion = planned(arm, "(turn left 90)", arm.ready);
  ASSERT_TRUE(motion) << motion.error().sentence;
  ASSERT_FALSE(motion->waypoints.empty());
  arm::Joints before = arm.ready;
  for (const arm::Joints& to : motion->waypoints) {
    ASSERT_TRUE(arm::check_limits(arm, to));
    const double mm = arm::forward(arm, between(before, to, 0.5)).translation().head<2>().norm();
    EXPECT_NEAR(mm, radius, 0.05);
    before = to;
  }
  // It has no room nearer than 50 mm to the base, or further aside than 500.
  const Eigen::Vector3d end = arm::forward(arm, before).translation();
  EXPECT_NEAR(end.x(), 50, 0.1);
  const Result<Motion> more = planned(arm, "(turn left 90)", before);
  ASSERT_TRUE(more);
  EXPECT_TRUE(more->at_limit);
  EXPECT_TRUE(more->waypoints.empty());
}

TEST(ArmsMotion, AnArmWhoseToolNothingTiltsSaysWhatItDoesInstead) {
  for (const char* name : {"gantry", "scara"}) {
    const arm::ArmModel arm = arm::shipped_arm(name).value();
    const Result<Motion> motion = planned(arm, "(turn-ef up 10)", arm.ready);
    ASSERT_FALSE(motion) << name;
    EXPECT_EQ(motion.error().symbol, "no-such-axis");
    EXPECT_EQ(motion.error().sentence, std::string("the tool of the arm ") + name +
                                           " always points down: (turn-wrist ...) turns it, and nothing tilts it");
  }
}

TEST(ArmsMotion, ToolIsClampedByItsStopsWhereALinkageHoldsIt) {
  const arm::ArmModel arm = arm::shipped_arm("crs-t265").value();
  const Result<Motion> motion = planned(arm, "(turn-ef down 180)", arm.ready);
  ASSERT_TRUE(motion);
  // The forearm is level, so the stops leave 110 degrees either way.
  EXPECT_NEAR(motion->waypoints.back()[3], -110, 1e-9);
}

TEST(ArmsMotion, TrackHelpsWhereALineGoesFurtherThanTheLinks) {
  const arm::ArmModel arm = arm::shipped_arm("crs-f3").value();
  const Result<Motion> motion = planned(arm, "(move-h right 900)", arm.ready);
  ASSERT_TRUE(motion) << motion.error().sentence;
  EXPECT_GT(motion->waypoints.back()[6], arm.ready[6] + 300);
  EXPECT_LT(deviation(arm, arm.ready, motion->waypoints).mm, 0.1);
  // Its links stretch, and nothing else does.
  EXPECT_EQ(planned(arm, "(extend keep-height 900)", arm.ready)->waypoints.back()[6], arm.ready[6]);
}

TEST(ArmsMotion, TrackIsCommandedByAnAction) {
  const arm::ArmModel arm = arm::shipped_arm("crs-f3").value();
  const Result<Motion> motion = planned(arm, "(do-action \"(track 3000)\")", arm.ready);
  ASSERT_TRUE(motion) << motion.error().sentence;
  EXPECT_EQ(motion->waypoints.back()[6], 3000);
  EXPECT_EQ(planned(arm, "(do-action \"(track 5001)\")", arm.ready).error().symbol, "joint-limit");
  EXPECT_EQ(planned(arm::shipped_arm("motoman-up6").value(), "(do-action \"(track 5)\")",
                    arm::shipped_arm("motoman-up6").value().ready)
                .error()
                .symbol,
            "no-such-axis");
}

}  // namespace
}  // namespace pizarra::robot
