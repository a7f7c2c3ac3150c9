#include "tests/drivers/arm/arms.hpp"

#include <fmt/format.h>
#include <fstream>
#include <numbers>

#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::arm {
namespace {

constexpr std::uint64_t first_seed = 20240607;

void expect_reached(const ArmModel& arm, const ToolPose& pose, const Joints& near, const std::string& what) {
  const Result<Joints> joints = inverse(arm, pose, near);
  ASSERT_TRUE(joints) << what << ": " << joints.error().sentence;
  ASSERT_TRUE(check_limits(arm, *joints)) << what;
  const ToolPose back = forward(arm, *joints);
  ASSERT_LT((back.translation() - pose.translation()).norm(), 0.01) << what;
  ASSERT_LT(angle_between_deg(back, pose), 0.001) << what;
}

TEST(Arms, EveryShippedArmIsDescribedInUnderSixtyLines) {
  for (const std::string& name : forms::arm_names()) {
    std::ifstream file(forms::shipped_arm_file(name));
    std::size_t lines = 0;
    for (std::string line; std::getline(file, line);) ++lines;
    EXPECT_LT(lines, 60U) << name;
  }
}

TEST(Arms, APoseInWhichTheToolLeansIsRefusedWhereItStands) {
  const std::string text = whole_file(forms::shipped_arm_file("crs-f3"));
  const std::string file = scratch_folder() + "leaning.scm";
  for (const auto& [pose, leaning] : {std::pair("(home  0 20 -80 0 -120", "(home  0 20 -80 0 -110"),
                                      std::pair("(ready 0 0 -90 0 -90", "(ready 0 0 -90 5 -90")}) {
    std::string changed = text;
    changed.replace(changed.find(pose), std::string_view(pose).size(), leaning);
    std::ofstream(file) << changed;
    const Result<ArmModel> arm = read_arm_file(file);
    ASSERT_FALSE(arm) << leaning;
    EXPECT_EQ(arm.error().symbol, "malformed");
    EXPECT_NE(arm.error().sentence.find("the tool points down there"), std::string::npos) << arm.error().sentence;
    EXPECT_NE(arm.error().place.find(std::string(leaning).substr(0, 5)), std::string::npos) << arm.error().place;
  }
}

TEST(Arms, EveryArmReachesFromAnywhereWhatItCanReach) {
  for (const ArmModel& arm : shipped_arms()) {
    Random random(first_seed);
    for (int i = 0; i < 3000; ++i) {
      Joints near = random_joints(arm, random);
      const Joints there = random_joints(arm, random);
      // Along the track there may be no more than a hair's breadth from which a pose can be reached.
      if (const auto track = arm.axis_of(Role::track)) near[*track] = there[*track];
      expect_reached(arm, forward(arm, there), near, fmt::format("{} seed {} case {}", arm.type, first_seed, i));
    }
  }
}

TEST(Arms, LimitsAndStretchedPosesAreReached) {
  for (const ArmModel& arm : shipped_arms()) {
    Random random(first_seed);
    for (int i = 0; i < 3000; ++i) {
      Joints there = random_joints(arm, random, true);
      const auto elbow = arm.axis_of(Role::elbow);
      const auto pitch = arm.axis_of(Role::pitch);
      // Stretched, and with forearm and tool in line.
      if (elbow && !arm.axes[*elbow].from_base && i % 3 == 1)
        there[*elbow] = -arm.axes[*elbow].sense * arm.axes[*elbow].zero;
      if (pitch && !arm.axes[*pitch].from_base && i % 5 == 1) there[*pitch] = 0;
      if (!check_limits(arm, there)) continue;
      expect_reached(arm, forward(arm, there), there, fmt::format("{} seed {} case {}", arm.type, first_seed, i));
    }
  }
}

TEST(Arms, ATrackGoesNoFurtherThanItMust) {
  for (const char* name : {"crs-f3", "crs-t265"}) {
    const ArmModel arm = shipped_arm(name).value();
    const std::size_t track = arm.axis_of(Role::track).value();
    Random random(first_seed);
    for (int i = 0; i < 200; ++i) {
      Joints near = random_joints(arm, random);
      const ToolPose pose = forward(arm, near);
      // One that is reached with room to spare keeps the track where it is.
      const Joints kept = inverse(arm, pose, near).value();
      if (kept[track] == near[track]) continue;
      near[track] = kept[track];
      const Joints again = inverse(arm, pose, near).value();
      EXPECT_NEAR(again[track], kept[track], 0.1) << name << " seed " << first_seed << " case " << i;
    }
    Joints away = arm.ready;
    away[track] = arm.axes[track].limits.high;
    expect_reached(arm, forward(arm, arm.ready), away, name);
  }
}

TEST(Arms, WhatIsOutOfReachIsRefusedAndWhatIsAcceptedIsReached) {
  for (const ArmModel& arm : shipped_arms()) {
    Random random(first_seed);
    int accepted = 0;
    for (int i = 0; i < 3000; ++i) {
      ToolPose pose = forward(arm, random_joints(arm, random));
      pose.translation() +=
          Eigen::Vector3d(random.uniform(-900, 900), random.uniform(-900, 900), random.uniform(-900, 900));
      const Joints near = random_joints(arm, random);
      pose = nearest_attainable(arm, pose, near);
      const Result<Joints> joints = inverse_in_place(arm, pose, near);
      if (!joints) continue;
      ++accepted;
      const ToolPose back = forward(arm, *joints);
      ASSERT_LT((back.translation() - pose.translation()).norm(), 0.01)
          << arm.type << " seed " << first_seed << " case " << i;
      ASSERT_LT(angle_between_deg(back, pose), 0.001) << arm.type << " seed " << first_seed << " case " << i;
    }
    EXPECT_GT(accepted, 5) << arm.type;
    ToolPose far = forward(arm, arm.ready);
    far.translation() += Eigen::Vector3d(20'000, 0, 0);
    ASSERT_FALSE(inverse(arm, far, arm.ready)) << arm.type;
  }
}

TEST(Arms, HomeAndReadyHaveTheToolDown) {
  for (const ArmModel& arm : shipped_arms()) {
    for (const Joints& pose : {arm.home, arm.ready}) {
      ASSERT_TRUE(check_limits(arm, pose)) << arm.type;
      EXPECT_NEAR(forward(arm, pose).linear().col(2).z(), -1, 1e-9) << arm.type;
    }
  }
}

TEST(Arms, ThesisArmsBeginOverTheTableAndFoldAboveATower) {
  for (const char* name : {"crs-f3", "crs-t265", "motoman-up6"}) {
    const ArmModel arm = shipped_arm(name).value();
    const Eigen::Vector3d ready = forward(arm, arm.ready).translation();
    EXPECT_NEAR(ready.x(), 400, 120) << name;
    EXPECT_NEAR(ready.y(), 0, 1) << name;
    EXPECT_NEAR(ready.z(), 380, 60) << name;
    EXPECT_GT(forward(arm, arm.home).translation().z(), 440) << name;
  }
}

// Tables B.1 to B.3 of the thesis, in each arm's own axes: the wrist centre d ahead of axis 2 and h above it, and how
// the tool keeps its direction.
struct Thesis {
  const char* arm;
  double a, b;
  double (*th1)(double j2, double j3);
  double (*th2)(double j2, double j3);
  double (*keeps)(double dj2, double dj3);  // what the end-effector axis turns
};
const double up6_b = std::hypot(130.0, 640.0);
const double up6_theta = std::acos(130.0 / up6_b) * 180 / std::numbers::pi;
const Thesis thesis[] = {
    {"crs-f3", 265, 270, [](double j2, double) { return 90 + j2; }, [](double j2, double j3) { return 90 + j2 + j3; },
     [](double dj2, double dj3) { return -(dj2 + dj3); }},
    {"crs-t265", 254, 254, [](double j2, double) { return j2; }, [](double, double j3) { return 90 + j3; },
     [](double, double) { return 0.0; }},
    {"motoman-up6", 570, up6_b, [](double l, double) { return 90 - l; },
     [](double l, double u) { return 90 - l + u - up6_theta; }, [](double dl, double du) { return dl - du; }}};

TEST(Arms, LinksStretchAsTheThesisSays) {
  for (const Thesis& table : thesis) {
    const ArmModel arm = shipped_arm(table.arm).value();
    Random random(first_seed);
    for (int i = 0; i < 500; ++i) {
      const Joints joints = random_joints(arm, random);
      const double th1 = table.th1(joints[1], joints[2]) * std::numbers::pi / 180;
      const double th2 = table.th2(joints[1], joints[2]) * std::numbers::pi / 180;
      const double c2 =
          table.a * table.a + table.b * table.b - 2 * table.a * table.b * std::cos(std::numbers::pi - th1 + th2);
      const Stretch stretch = stretch_of(arm, joints);
      EXPECT_NEAR(stretch.d_mm, table.a * std::cos(th1) + table.b * std::cos(th2), 1e-6) << table.arm;
      EXPECT_NEAR(stretch.h_mm, table.a * std::sin(th1) + table.b * std::sin(th2), 1e-6) << table.arm;
      EXPECT_NEAR(std::hypot(stretch.d_mm, stretch.h_mm), std::sqrt(c2), 1e-6) << table.arm;
    }
  }
}

TEST(Arms, EndEffectorAxisCompensatesAsTheThesisSays) {
  for (const Thesis& table : thesis) {
    const ArmModel arm = shipped_arm(table.arm).value();
    const std::size_t pitch = arm.axis_of(Role::pitch).value();
    ToolPose pose = forward(arm, arm.ready);
    pose.translation() += Eigen::Vector3d(12, 0, -25);
    const Joints moved = inverse_in_place(arm, pose, arm.ready).value();
    const double compensation = table.keeps(moved[1] - arm.ready[1], moved[2] - arm.ready[2]);
    EXPECT_NEAR(moved[pitch] - arm.ready[pitch], compensation, 1e-9) << table.arm;
  }
}

TEST(Arms, MechanicallyCoupledToolIsBlockedByItsStopsFarFromTheLimitsOfTheOtherAxes) {
  const ArmModel arm = shipped_arm("crs-t265").value();
  Joints level = arm.ready;
  level[1] = 60;
  level[2] = -65;  // the forearm 25 degrees up, its limit is 90
  const Result<void> blocked = check_limits(arm, level);
  ASSERT_FALSE(blocked);
  EXPECT_EQ(blocked.error().symbol, "joint-limit");
  EXPECT_EQ(blocked.error().subject, to_datum(4));
  level[3] = -80;  // the tool raised by ten degrees leaves the stop
  EXPECT_TRUE(check_limits(arm, level));
}

TEST(Arms, FiveAxesTurnTheToolIntoTheirPlaneAndSixKeepIt) {
  const ArmModel five = shipped_arm("crs-t265").value();
  Joints level = five.ready;
  level[3] = -30;
  ToolPose aside = forward(five, level);
  aside.translation().y() += 40;
  EXPECT_FALSE(inverse_in_place(five, aside, level)) << "the tool points out of the plane";
  const ToolPose turned = nearest_attainable(five, aside, level);
  EXPECT_TRUE(inverse_in_place(five, turned, level));
  EXPECT_LT(angle_between_deg(turned, aside), 6);
  EXPECT_EQ((nearest_attainable(crs_f3(), aside, crs_f3().ready).matrix() - aside.matrix()).norm(), 0);
}

}  // namespace
}  // namespace pizarra::arm
