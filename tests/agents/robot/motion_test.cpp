#include "agents/robot/motion.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "agents/robot/tool_path.hpp"
#include "blackboard/time/random.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/kinematics.hpp"
#include "lisp/reader.hpp"

namespace pizarra::robot {
namespace {

const arm::ArmModel& model = arm::crs_f3();
const arm::Joints at_work{0, -40, -80, 0, -60, 0, 2500};

Result<Motion> planned(std::string_view operation, const arm::Joints& from = at_work,
                       const ArmVariables& variables = {}) {
  return plan_motion(model, read_one(operation).value(), from, variables);
}

Eigen::Vector3d point(const arm::Joints& joints) { return arm::forward(model, joints).translation(); }

std::string refusal(std::string_view operation, const arm::Joints& from = at_work, const ArmVariables& variables = {}) {
  const Result<Motion> motion = planned(operation, from, variables);
  return motion ? "" : motion.error().symbol;
}

// The furthest that the way between the waypoints leaves the line from `from` to the end, mm.
double deviation_mm(const arm::Joints& from, const std::vector<arm::Joints>& waypoints) {
  const Eigen::Vector3d start = point(from);
  const Eigen::Vector3d along = (point(waypoints.back()) - start).normalized();
  double worst = 0;
  arm::Joints before = from;
  for (const arm::Joints& to : waypoints) {
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      arm::Joints between(before.size());
      for (std::size_t axis = 0; axis < before.size(); ++axis)
        between[axis] = before[axis] + part * (to[axis] - before[axis]);
      const Eigen::Vector3d off = point(between) - start;
      worst = std::max(worst, (off - off.dot(along) * along).norm());
    }
    before = to;
  }
  return worst;
}

TEST(Motion, MovesGoWhereTheirNamesSayAndKeepTheToolDirection) {
  struct Case {
    std::string_view operation;
    Eigen::Vector3d offset;
  };
  for (const Case& given : {Case{"(move-h right 50)", {0, 50, 0}}, Case{"(move-h left 50)", {0, -50, 0}},
                            Case{"(move-v up 50)", {0, 0, 50}}, Case{"(move-v down 50)", {0, 0, -50}},
                            Case{"(extend keep-height 40)", {40, 0, 0}}, Case{"(retract 40)", {-40, 0, 0}},
                            Case{"(extend keep-distance 40)", {0, 0, 40}}}) {
    const Result<Motion> motion = planned(given.operation);
    ASSERT_TRUE(motion) << given.operation << " " << motion.error().sentence;
    const arm::ToolPose end = arm::forward(model, motion->waypoints.back());
    EXPECT_LT((end.translation() - point(at_work) - given.offset).norm(), 1e-6) << given.operation;
    EXPECT_LT((end.linear() - arm::forward(model, at_work).linear()).norm(), 1e-9) << given.operation;
    EXPECT_LT(deviation_mm(at_work, motion->waypoints), 0.1) << given.operation;
  }
}

TEST(Motion, EndEffectorAxisTakesBackWhatTheLinksTurn) {
  const Result<Motion> motion = planned("(extend keep-height 60)", {25, -40, -80, 0, -50, 10, 2500});
  ASSERT_TRUE(motion);
  const arm::Joints& end = motion->waypoints.back();
  EXPECT_NEAR(end[4] + 50, -((end[1] + 40) + (end[2] + 80)), 1e-9);
  EXPECT_NEAR(end[0], 25, 1e-9);
  EXPECT_NEAR(end[5], 10, 1e-9);
}

TEST(Motion, ExtendKeepingTheAngleLengthensTheLinksAlone) {
  const arm::Stretch before = arm::stretch_of(model, at_work);
  const Result<Motion> motion = planned("(extend keep-angle 30)");
  ASSERT_TRUE(motion);
  const arm::Stretch after = arm::stretch_of(model, motion->waypoints.back());
  EXPECT_NEAR(std::hypot(after.d_mm, after.h_mm), std::hypot(before.d_mm, before.h_mm) + 30, 1e-6);
  EXPECT_NEAR(std::atan2(after.h_mm, after.d_mm), std::atan2(before.h_mm, before.d_mm), 1e-9);
}

TEST(Motion, EachOperationPastItsLimitEndsThereAndThenMovesNoFurther) {
  for (const std::string_view operation :
       {"(extend keep-height 900)", "(extend keep-distance 900)", "(extend keep-angle 900)", "(retract 900)",
        "(move-h left 9000)", "(move-h right 9000)", "(move-v up 9000)", "(move-v down 9000)", "(turn left 9000)",
        "(turn right 9000)", "(turn-ef up 9000)", "(turn-ef down 9000)", "(turn-wrist left 1e300)",
        "(turn-wrist right 1e300)", "(extend keep-height 1e300)", "(retract 1e300)"}) {
    const Result<Motion> motion = planned(operation);
    ASSERT_TRUE(motion) << operation;
    ASSERT_FALSE(motion->waypoints.empty()) << operation;
    const arm::Joints end = motion->waypoints.back();
    EXPECT_TRUE(arm::check_limits(model, end)) << operation;
    const Result<Motion> again = planned(operation, end);
    ASSERT_TRUE(again) << operation;
    EXPECT_TRUE(again->waypoints.empty()) << operation;
    EXPECT_TRUE(again->at_limit) << operation;
  }
}

TEST(Motion, FromItsLimitALineLeadsBack) {
  for (const auto& [there, back] :
       {std::pair("(move-v up 9000)", "(move-v down 200)"), std::pair("(move-v down 9000)", "(move-v up 200)"),
        std::pair("(move-h left 9000)", "(move-h right 200)")}) {
    const arm::Joints end = planned(there)->waypoints.back();
    const Result<Motion> motion = planned(back, end);
    ASSERT_TRUE(motion) << back << ": " << motion.error().sentence;
    ASSERT_FALSE(motion->waypoints.empty()) << back;
    EXPECT_NEAR((point(motion->waypoints.back()) - point(end)).norm(), 200, 0.1) << back;
  }
}

TEST(Motion, ALinePastTheReachIsFollowedAsFarAsItCan) {
  for (const std::string_view operation : {"(move-h left 9000)", "(move-v up 9000)", "(move-v down 9000)"}) {
    const Result<Motion> motion = planned(operation);
    ASSERT_TRUE(motion) << operation;
    EXPECT_GT((point(motion->waypoints.back()) - point(at_work)).norm(), 50) << operation;
    EXPECT_LT(deviation_mm(at_work, motion->waypoints), 0.1) << operation;
  }
}

TEST(Motion, FullExtensionIsFoundToAHundredthOfAMillimetre) {
  // Tool level, so that no axis limit but the links' length ends it.
  const arm::Joints level{0, -30, -60, 0, 0.5, 0, 2500};
  const Result<Motion> motion = planned("(extend keep-height 900)", level);
  ASSERT_TRUE(motion);
  const double h = arm::stretch_of(model, level).h_mm;
  const double full = std::sqrt(std::pow(model.upper_arm_mm + model.elbow_to_wrist_mm(), 2) - h * h);
  EXPECT_NEAR(arm::stretch_of(model, motion->waypoints.back()).d_mm, full, 0.01);
}

TEST(Motion, TurnsAreClampedAndRoundedToAHundredthOfADegree) {
  EXPECT_NEAR(planned("(turn right 12.344)")->waypoints.back()[0], 12.34, 1e-9);
  EXPECT_NEAR(planned("(turn left 30)")->waypoints.back()[0], -30, 1e-9);
  EXPECT_NEAR(planned("(turn right 300)")->waypoints.back()[0], 180, 1e-9);
  EXPECT_TRUE(planned("(turn right 1)", {180, -40, -80, 0, -60, 0, 2500})->at_limit);
  EXPECT_NEAR(planned("(turn-ef up 10)")->waypoints.back()[4], -50, 1e-9);
  EXPECT_NEAR(planned("(turn-ef down 200)")->waypoints.back()[4], -135, 1e-9);
  EXPECT_NEAR(planned("(turn-wrist right 400)")->waypoints.back()[5], 400, 1e-9);
}

TEST(Motion, WristTurnedLeftTakesBackATurnToTheRight) {
  const arm::Joints turned = planned("(turn right 20)")->waypoints.back();
  const arm::Joints back = planned("(turn-wrist left 20)", turned)->waypoints.back();
  EXPECT_LT((arm::forward(model, back).linear() - arm::forward(model, at_work).linear()).norm(), 1e-9);
}

TEST(Motion, NothingAskedForIsNothingMovedAndNoLimit) {
  for (const std::string_view operation : {"(move-v up 0)", "(turn left 0)", "(extend keep-angle 0)"}) {
    const Result<Motion> motion = planned(operation);
    ASSERT_TRUE(motion);
    EXPECT_TRUE(motion->waypoints.empty());
    EXPECT_FALSE(motion->at_limit) << operation;
  }
  EXPECT_TRUE(planned("(ready)", model.ready)->waypoints.empty());
}

TEST(Motion, ALineToAPointEndsThereOrIsRefused) {
  const Eigen::Vector3d to(400, 50, 150);
  const Result<Motion> motion = planned("(move-to 400 50 150)");
  ASSERT_TRUE(motion) << motion.error().sentence;
  EXPECT_LT((point(motion->waypoints.back()) - to).norm(), 0.01);
  EXPECT_LT(deviation_mm(at_work, motion->waypoints), 0.1);
  EXPECT_EQ(motion->waypoints, planned("(do-action \"(move 400 50 150)\")")->waypoints);
  EXPECT_EQ(refusal("(move-to 400 50 -9999)"), "unreachable");
  EXPECT_EQ(refusal("(move-to 400 50000 150)"), "unreachable");
}

TEST(Motion, BadDirectionsAndAmountsAreRefused) {
  EXPECT_EQ(refusal("(turn up 10)"), "wrong-direction");
  EXPECT_EQ(refusal("(move-v left 10)"), "wrong-direction");
  EXPECT_EQ(refusal("(extend sideways 10)"), "wrong-direction");
  EXPECT_EQ(refusal("(turn left -10)"), "out-of-range");
  EXPECT_EQ(refusal("(retract -1)"), "out-of-range");
  EXPECT_EQ(refusal("(move-h left -1)"), "out-of-range");
}

// Near the end of an axis, where the track would have to help at once.
TEST(Motion, WhereATrackCannotHelpALineIsFollowedByTheLinksAlone) {
  const arm::Joints folded{53, -68, 134, 66, 19, 371, 3961};
  ToolPath path(model, folded);
  const LineEnd end = path.line_by({0, 0, 200});
  ASSERT_TRUE(end.ended_by);
  EXPECT_EQ(end.ended_by->symbol, "singular");
  EXPECT_EQ(end.ended_by->subject, to_datum(7));
  EXPECT_EQ(end.ended_by->sentence,
            "axis 7 would have to jump 0.00 mm along the line, at (-102.3 1426.6 613.1), to keep the arm on it");
  const Result<Motion> motion = planned("(move-v up 200)", folded);
  ASSERT_TRUE(motion) << motion.error().sentence;
  for (const arm::Joints& joints : motion->waypoints) EXPECT_EQ(joints[6], folded[6]);
}

TEST(Motion, GotoLeadsToTheLearnedJointsAndNamesTheNearestForAnUnknownOne) {
  const ArmVariables variables{{"shelf", {10, -30, -70, 0, -80, 5, 2500}}};
  EXPECT_EQ(planned("(goto shelf)", at_work, variables)->waypoints.back(), variables.at("shelf"));
  const Result<Motion> unknown = planned("(goto shelv)", at_work, variables);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().symbol, "unknown-variable");
  EXPECT_NE(unknown.error().sentence.find("shelf"), std::string::npos);
}

// The elbow stands at its limit, and the arm could go on only with its back to the point.
TEST(Motion, DownFromWhereTheElbowIsFoldedATrackCarriesTheArmInItsPosture) {
  const arm::Joints folded{-38.24, 27.657, -134.83, 0, -72.827, 38.24, 2500};
  ToolPath path(model, folded);
  const LineEnd end = path.line_by({0, 0, -90});
  ASSERT_FALSE(end.ended_by) << end.ended_by->sentence;
  EXPECT_NEAR(path.point().z(), point(folded).z() - 90, 0.1);
  EXPECT_LT(deviation_mm(folded, path.waypoints()), 0.1);
  EXPECT_NE(path.joints()[6], folded[6]);
  ToolPath in_place(model, folded, ToolPath::Track::stays);
  EXPECT_TRUE(in_place.line_by({0, 0, -90}).ended_by);
}

TEST(Motion, RandomStraightMovesStayOnTheirLine) {
  constexpr std::uint64_t seed = 11;
  Random random(seed);
  int planned_moves = 0;
  for (int i = 0; i < 300; ++i) {
    ToolPath path(model, at_work);
    const LineEnd there = path.line_to({random.uniform(380, 500), random.uniform(-230, 230), random.uniform(30, 350)});
    ASSERT_FALSE(there.ended_by) << "seed " << seed << " case " << i << " " << there.ended_by->sentence;
    const arm::Joints from = path.joints();
    ToolPath line(model, from);
    const LineEnd end = line.line_to({random.uniform(380, 500), random.uniform(-230, 230), random.uniform(30, 350)});
    ASSERT_FALSE(end.ended_by) << "seed " << seed << " case " << i << " " << end.ended_by->sentence;
    EXPECT_LT(deviation_mm(from, line.waypoints()), 0.1) << "seed " << seed << " case " << i;
    ++planned_moves;
  }
  EXPECT_EQ(planned_moves, 300);
}

}  // namespace
}  // namespace pizarra::robot
