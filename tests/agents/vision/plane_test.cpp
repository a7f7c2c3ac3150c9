// A mark's outline registered with an image, and where that puts its plane: of squares, triangles and crosses that are
// projected from known poses, with nothing of the cell's renderers.

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "agents/vision/objects/plane_look.hpp"
#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "agents/vision/sight/plane_view.hpp"
#include "agents/vision/sight/seen_range.hpp"
#include "tests/agents/vision/drawn_planes.hpp"

namespace pizarra::vision {
namespace {

std::size_t bends_of(const PlaneOutline& outline) {
  return static_cast<std::size_t>(
      std::ranges::count_if(outline.points, [](const PlaneOutline::Point& point) { return point.from_bend == 0; }));
}

TEST(PlaneOutline, BendsWhereTheShapeHasCornersThoughTheTemplateRoundsThem) {
  Random random(14);
  EXPECT_EQ(bends_of(learned(square, random).plane), square.size());
  EXPECT_EQ(bends_of(learned(cross, random).plane), cross.size());
}

std::size_t sides_of(const PlaneOutline& outline) {
  std::set<std::size_t> sides;
  for (const PlaneOutline::Point& point : outline.points) sides.insert(point.side);
  sides.erase(OutlinePoint::no_side);
  return sides.size();
}

TEST(PlaneOutline, HasAsManySidesAsTheShape) {
  Random random(16);
  EXPECT_EQ(sides_of(learned(square, random).plane), 4);
  EXPECT_EQ(sides_of(learned({{-21, 12}, {21, 12}, {0, -24}}, random).plane), 3);
  EXPECT_EQ(sides_of(learned({{-22, 15}, {25, 12}, {16, -14}, {-19, -17}}, random).plane), 4);
}

// A mark seems narrower on the side that lies in the shade.
TEST(PlaneOutline, IsAsWideAsItIsHighThoughLightFallsFromOneSide) {
  Random random(15);
  for (const Corners& shape : {square, cross}) {
    const LearnedSample sample = learned(shape, random, 0.006);
    std::vector<cv::Point2d> outline;
    for (const PlaneOutline::Point& point : sample.plane.points) outline.emplace_back(point.at);
    const std::optional<Reach> reach = reach_of(outline);
    ASSERT_TRUE(reach);
    EXPECT_NEAR(reach->spread(0, 0), reach->spread(1, 1), 0.0005);
    EXPECT_NEAR(reach->spread(0, 1), 0, 0.0005);
  }
}

// Of the errors of both angles of its tilt, each divided by the spread that was told: the sum of squares. A quarter of
// a turn leaves the shape as it is.
double squares_in_spreads(const PlaneTilt& told, const cv::Matx33d& turn) {
  cv::Matx33d nearest = turn;
  for (int quarter = 1; quarter < 4; ++quarter) {
    const cv::Matx33d same = turn * turned_about({0, 0, quarter * CV_PI / 2});
    if (cv::norm(same - told.turn) < cv::norm(nearest - told.turn)) nearest = same;
  }
  cv::Vec3d off;
  cv::Rodrigues(nearest * told.turn.t(), off);
  double out = 0;
  for (const int axis : {0, 1}) {
    const Eigen::Vector3d about(told.turn(0, axis), told.turn(1, axis), told.turn(2, axis));
    const double angle = Eigen::Vector3d(off[0], off[1], off[2]).dot(about);
    out += angle * angle / about.dot(told.covariance.bottomRightCorner<3, 3>() * about);
  }
  return out;
}

// The root of their mean.
double angles_in_spreads(const Corners& shape, Random& random) {
  constexpr double noise = 2;
  constexpr int finer = 32;
  const LearnedSample sample = learned(shape, random);
  double squares = 0;
  constexpr int tries = 60;
  for (int i = 0; i < tries; ++i) {
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * random.uniform(0.4, 0.9)) *
                             turned_about({0, 0, random.uniform(-0.7, 0.7)});
    const cv::Vec3d place(random.uniform(-120, 120), random.uniform(-80, 80), random.uniform(400, 600));
    const std::optional<Registered> seen =
        registered(filled(projected(shape, turn, place), random, noise, finer), sample);
    if (!seen) throw std::runtime_error("it is not seen");
    squares += std::min(squares_in_spreads(seen->pose, turn), squares_in_spreads(seen->pose.other, turn));
  }
  return std::sqrt(squares / (2 * tries));
}

TEST(Plane, IsTurnedAboutAsFarOffAsItsSpreadsSay) {
  Random random(16);
  for (const Corners& shape : {square, cross}) {
    const double off = angles_in_spreads(shape, random);
    EXPECT_GT(off, 0.5);
    EXPECT_LT(off, 1.5);
  }
}

cv::Matx33d any_turn(Random& random, double least_tilt, double most_tilt) {
  const double lies = random.uniform(0, 2 * CV_PI);
  const cv::Vec3d axis(std::cos(lies), std::sin(lies), 0);
  return turned_about(axis * random.uniform(least_tilt, most_tilt)) *
         turned_about({0, 0, random.uniform(-CV_PI, CV_PI)});
}

// Half a turn leaves a rectangle as it is.
double off_deg(const PlaneTilt& told, const cv::Matx33d& turn) {
  double least = 180;
  for (const double half : {0.0, CV_PI}) {
    cv::Vec3d off;
    cv::Rodrigues(told.turn * turned_about({0, 0, half}) * turn.t(), off);
    least = std::min(least, cv::norm(off) * 180 / CV_PI);
  }
  return least;
}

// A brick's long side. Whichever way it lay while it was learned, its picture is as high as it is wide.
TEST(Plane, OfASlimMarkLiesAsItWasDrawnWhicheverWayItWasLearned) {
  const Corners rectangle = {{-26, -12}, {26, -12}, {26, 12}, {-26, 12}};
  const Corners wedge = {{-26, -12}, {26, -6}, {26, 6}, {-26, 12}};
  const Corners ell = {{-26, -14}, {26, -14}, {26, -2}, {-10, -2}, {-10, 14}, {-26, 14}};
  Random random(22);
  for (const auto& [name, shape] :
       std::map<std::string, Corners>{{"rectangle", rectangle}, {"wedge", wedge}, {"ell", ell}}) {
    double squares_deg2 = 0;
    double squares_of_depth = 0;
    constexpr int tries = 40;
    for (int i = 0; i < tries; ++i) {
      const cv::Matx33d roll = turned_about({0, 0, random.uniform(-CV_PI, CV_PI)});
      Corners rolled;
      for (const cv::Point2d& p : shape) {
        const cv::Vec3d at = roll * cv::Vec3d(p.x, p.y, 0);
        rolled.emplace_back(at[0], at[1]);
      }
      const LearnedSample sample = learned(rolled, random);
      ASSERT_LT(sample.slimness, least_round);
      const cv::Matx33d turn = any_turn(random, 0.35, 0.8);
      const cv::Vec3d place(random.uniform(-120, 120), random.uniform(-80, 80), random.uniform(400, 600));
      const std::optional<Registered> seen = registered(filled(projected(rolled, turn, place), random, 1, 32), sample);
      ASSERT_TRUE(seen) << i;
      const double off = std::min(off_deg(seen->pose, turn), off_deg(seen->pose.other, turn));
      EXPECT_LT(off, 12) << i;
      squares_deg2 += off * off / tries;
      squares_of_depth += std::pow(seen->pose.place_mm[2] / place[2] - 1, 2) / tries;
    }
    RecordProperty(name + "_off_deg", std::to_string(std::sqrt(squares_deg2)));
    RecordProperty(name + "_depth_off", std::to_string(std::sqrt(squares_of_depth)));
    EXPECT_LT(std::sqrt(squares_deg2), 3) << name;
    EXPECT_LT(std::sqrt(squares_of_depth), 0.012) << name;
  }
}

TEST(Plane, OfASlimMarkIsToldByFindAndByTrack) {
  Random random(23);
  LearnedObjects objects;
  LearnedSample brick = learned({{-26, -12}, {26, -12}, {26, 12}, {-26, 12}}, random);
  brick.number = 1;
  objects.add("brick", brick);
  const cv::Matx33d turn = turned_about({0.3, 0.45, 0});
  const cv::Vec3d place(30, -20, 480);
  const Corners seen = projected({{-26, -12}, {26, -12}, {26, 12}, {-26, 12}}, turn, place);
  const cv::Mat1b image = filled(seen, random, 1, 32);
  const camera::StereoModel model = one_camera();
  StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
  const Result<FoundMark> found = MarkFinder(objects).find(sight, objects.all().front(), {});
  ASSERT_TRUE(found) << found.error().sentence;
  MarkTracker tracker(objects);
  ASSERT_TRUE(tracker.add(objects.all().front()));
  const TrackSighting tracked = tracker.update(sight, Time()).front();
  for (const std::optional<MarkPose>& pose : {found->pose, tracked.pose}) {
    ASSERT_TRUE(pose);
    EXPECT_LT(degrees_between(pose->turn, turn), 4);
    EXPECT_NEAR(pose->place_mm[2], place[2], 6);
  }
}

// Blur moves an arc inwards, and motion blurs two sides of it alone: that looks like a tilt of five degrees.
TEST(Plane, OfACircleThatMovesFacesTheCamera) {
  Random random(19);
  const LearnedSample sample = learned(circle(), random);
  for (const int motion_px : {5, 9}) {
    cv::Mat1b image = filled(projected(circle(), cv::Matx33d::eye(), {0, 0, 500}), random, 1, 32);
    cv::blur(image, image, {motion_px, 1});
    const std::optional<Registered> seen = registered(image, sample);
    ASSERT_TRUE(seen);
    EXPECT_LT(degrees_between(seen->pose.turn, cv::Matx33d::eye()), 2) << motion_px;
  }
}

// The ground of one side is lighter than white, by a lamp's reflection that falls on the print as well.
TEST(Plane, OfASquareWithASideInGlareIsWithinItsSpreads) {
  Random random(20);
  const LearnedSample sample = learned(square, random);
  double squares = 0;
  constexpr int tries = 40;
  for (int i = 0; i < tries; ++i) {
    SCOPED_TRACE(i);
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * random.uniform(0, 0.3)) *
                             turned_about({0, 0, random.uniform(-0.7, 0.7)});
    const cv::Vec3d place(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(400, 600));
    cv::Mat1b image = filled(projected(square, turn, place), random, 1, 32);
    const double from = projected({{0, 0}}, turn, place).front().x;
    for (int x = 0; x < image.cols; ++x) image.col(x) += std::clamp(2 * (x - from), 0.0, 110.0);
    const std::optional<Registered> seen = registered(image, sample);
    ASSERT_TRUE(seen);
    squares += std::min(squares_in_spreads(seen->pose, turn), squares_in_spreads(seen->pose.other, turn));
  }
  EXPECT_LT(std::sqrt(squares / (2 * tries)), 1);
}

TEST(Plane, OfATiltedSquareIsWhereTheSquareIs) {
  Random random(5);
  const LearnedSample sample = learned(square, random);
  double squares = 0;
  constexpr int tries = 40;
  for (int i = 0; i < tries; ++i) {
    SCOPED_TRACE(i);
    const double tilt = random.uniform(25, 55) * CV_PI / 180;
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * tilt) *
                             turned_about({0, 0, random.uniform(-0.5, 0.5)});
    const cv::Vec3d place(random.uniform(-120, 120), random.uniform(-80, 80), random.uniform(400, 700));
    const std::optional<Registered> seen = registered(filled(projected(square, turn, place), random), sample);
    ASSERT_TRUE(seen);
    const cv::Point2d middle = projected({{0, 0}}, turn, place).front();
    EXPECT_LT(cv::norm(seen->fit.in_image({0, 0}) - middle), 0.3);
    EXPECT_NEAR(cv::norm(seen->pose.place_mm), cv::norm(place), 0.02 * cv::norm(place));
    const double off = degrees_between(seen->pose.turn, turn);
    squares += off * off;
    EXPECT_LT(covered_rather_than_tilted(seen->pose, 1), 0.3);
  }
  EXPECT_LT(std::sqrt(squares / tries), 3);
}

// A template rounds the corners of what it was learned from, each edge beside them by a tenth of the mark's standard
// deviation: from near by that is pixels.
TEST(Plane, OfACrossThatIsNearerThanItWasLearnedAgreesAndIsNotBent) {
  Random random(19);
  const LearnedSample sample = learned(cross, random);
  for (const double depth_mm : {270, 300, 340, 420}) {
    SCOPED_TRACE(depth_mm);
    const cv::Matx33d turn = turned_about({0.15, -0.1, random.uniform(-3, 3)});
    const std::optional<Registered> seen =
        registered(filled(projected(cross, turn, {5, -3, depth_mm}), random), sample);
    ASSERT_TRUE(seen);
    EXPECT_LT(off_if_bent_px(sample.plane, seen->fit), 0.5);
  }
}

// A homography leaves more open than a pose does: of a cross's middle a tenth of a pixel.
TEST(Plane, PutsTheMiddleOfACrossWhereItsPoseIs) {
  Random random(12);
  const LearnedSample sample = learned(cross, random);
  double squares = 0;
  constexpr int tries = 40;
  for (int i = 0; i < tries; ++i) {
    SCOPED_TRACE(i);
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * random.uniform(0, 0.9)) *
                             turned_about({0, 0, random.uniform(-3, 3)});
    const cv::Vec3d place(random.uniform(-120, 120), random.uniform(-80, 80), random.uniform(400, 600));
    const std::optional<Registered> seen = registered(filled(projected(cross, turn, place), random), sample);
    ASSERT_TRUE(seen);
    const double off =
        cv::norm(middle_in_image(one_camera(), seen->pose, 2) - projected({{0, 0}}, turn, place).front());
    squares += off * off;
  }
  EXPECT_LT(std::sqrt(squares / tries), 0.06);
}

// Two tilts of a circle look alike, and put its middle in two places. Telling one of them
// would be off by 0.7 of the way between them, root mean square.
TEST(Plane, PutsTheMiddleOfACircleBetweenBothOfItsTilts) {
  Random random(13);
  const LearnedSample sample = learned(circle(), random);
  double off2 = 0;
  double apart2 = 0;
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * random.uniform(0.3, 0.9));
    const cv::Vec3d place(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(400, 600));
    const std::optional<Registered> seen = registered(filled(projected(circle(), turn, place), random), sample);
    ASSERT_TRUE(seen);
    const auto in_image = [](const cv::Vec3d& at) { return projected({{0, 0}}, cv::Matx33d::eye(), at).front(); };
    const double apart = cv::norm(in_image(seen->pose.place_mm) - in_image(seen->pose.other.place_mm));
    const double off = cv::norm(middle_in_image(one_camera(), seen->pose, 2) - in_image(place));
    apart2 += apart * apart;
    off2 += off * off;
    // Neither is farther off than may be.
    const cv::Point2d between = middle_in_image(one_camera(), seen->pose, 0.6 * apart);
    EXPECT_LT(cv::norm(between - in_image(place)), 0.6 * apart + 0.1);
  }
  EXPECT_LT(off2, 0.4 * apart2);
}

// An outline says nothing of its own stretch: of a triangle that is a little wider than high, that is a part of what
// its tilt may be.
TEST(Plane, OfATiltedTriangleIsWithinItsSpreads) {
  Random random(9);
  const LearnedSample sample = learned({{0, -2 * 37 / 3.0}, {22, 37 / 3.0}, {-22, 37 / 3.0}}, random);
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const double tilt = random.uniform(25, 50) * CV_PI / 180;
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * tilt);
    const cv::Vec3d place(random.uniform(-100, 100), random.uniform(-60, 60), random.uniform(400, 600));
    const Corners triangle = projected({{0, -2 * 37 / 3.0}, {22, 37 / 3.0}, {-22, 37 / 3.0}}, turn, place);
    const std::optional<Registered> seen = registered(filled(triangle, random), sample);
    ASSERT_TRUE(seen);
    const auto spreads_off = [&](const PlaneTilt& told) {
      return degrees_between(told.turn, turn) * CV_PI / 180 /
             std::sqrt(told.covariance.bottomRightCorner<3, 3>().trace());
    };
    EXPECT_LT(std::min(spreads_off(seen->pose), spreads_off(seen->pose.other)), 2);
  }
}

// Beside the camera's axis a face that is turned outwards looks narrower still than its tilt makes it.
TEST(Plane, OfACircleThatIsTiltedFarFromTheAxisIsFound) {
  Random random(24);
  LearnedObjects objects;
  LearnedSample sample = learned(circle(), random);
  sample.number = 1;
  objects.add("circle", sample);
  const camera::StereoModel model = one_camera();
  for (const double tilt_deg : {53.0, 55.0, 57.0}) {
    SCOPED_TRACE(tilt_deg);
    const cv::Matx33d turn = turned_about({0, tilt_deg * CV_PI / 180, 0});
    const cv::Vec3d place(-190, 20, 480);
    const cv::Mat image = filled(projected(circle(), turn, place), random);
    StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
    const Result<FoundMark> found = MarkFinder(objects).find(sight, *objects.find("circle"), {});
    ASSERT_TRUE(found);
    EXPECT_LT(found->pair.left.slimness, 0.3);
    EXPECT_LT(cv::norm(found->pair.left.centre - projected({{0, 0}}, turn, place).front()), 1);
    EXPECT_LT(found->confidence, 0.9);
  }
}

// A house's window is a square as well, but for its perspective: no pose of a square of this size has these edges.
TEST(Plane, OfTwoSquaresTheOneIsFoundThatIsASquareHoweverItLies) {
  Random random(17);
  LearnedObjects objects;
  LearnedSample sample = learned(square, random);
  sample.number = 1;
  objects.add("square", sample);
  const camera::StereoModel model = one_camera();
  const Corners window = {{200, 200}, {246, 199}, {246, 246}, {200, 244}};
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const cv::Matx33d turn =
        turned_about({random.uniform(0.5, 0.7), random.uniform(-0.4, 0.4), random.uniform(-0.3, 0.3)});
    const cv::Vec3d place(random.uniform(60, 120), random.uniform(-80, 80), random.uniform(450, 700));
    cv::Mat image = filled(projected(square, turn, place), random);
    image = cv::min(image, cv::Mat(filled(window, random)));
    StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
    const Result<FoundMark> found = MarkFinder(objects).find(sight, *objects.find("square"), {});
    ASSERT_TRUE(found);
    EXPECT_LT(cv::norm(found->pair.left.centre - projected({{0, 0}}, turn, place).front()), 1);
  }
}

TEST(Plane, OfAPartOfASquareThatLooksTiltedHasNoPerspective) {
  Random random(6);
  const LearnedSample sample = learned(square, random);
  for (const double left : {0.6, 0.75}) {
    Corners part = square;
    part[1].x = part[2].x = -half_mm + 2 * half_mm * left;
    const std::optional<Registered> seen =
        registered(filled(projected(part, turned_about({0, 0, 0.2}), {0, 0, 500}), random), sample);
    ASSERT_TRUE(seen);
    EXPECT_GT(covered_rather_than_tilted(seen->pose, 6), 0.9);
  }
}

TEST(Plane, ToldWithTwoSpreadsHoldsMostRanges) {
  Random random(7);
  const LearnedSample sample = learned(square, random);
  int within = 0;
  constexpr int tries = 60;
  for (int i = 0; i < tries; ++i) {
    const double tilt = random.uniform(20, 50) * CV_PI / 180;
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * tilt);
    const cv::Vec3d place(random.uniform(-100, 100), random.uniform(-60, 60), random.uniform(400, 700));
    const std::optional<Registered> seen = registered(filled(projected(square, turn, place), random), sample);
    if (!seen) continue;
    const double spread = std::hypot(std::sqrt(seen->pose.covariance(2, 2)), 0.01 * place[2]);
    within += std::abs(seen->pose.place_mm[2] - place[2]) < 2 * spread ? 1 : 0;
  }
  EXPECT_GE(within, 0.9 * tries);
}

// Perspective hardly tells its two tilts apart, and in the other one it would be one or two percent elsewhere.
TEST(Plane, OfATiltedTriangleIsAtARangeWithinItsSpread) {
  const Corners triangle = {{0, -23}, {20, 23 / 2.0}, {-20, 23 / 2.0}};
  Random random(21);
  LearnedObjects objects;
  LearnedSample sample = learned(triangle, random);
  sample.number = 1;
  objects.add("triangle", sample);
  int within = 0;
  constexpr int tries = 40;
  for (int i = 0; i < tries; ++i) {
    SCOPED_TRACE(i);
    const double lies = random.uniform(0, 2 * CV_PI);
    const cv::Matx33d turn = turned_about(cv::Vec3d(std::cos(lies), std::sin(lies), 0) * random.uniform(0.6, 0.9));
    const cv::Vec3d place(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(400, 600));
    const std::optional<Registered> seen = registered(filled(projected(triangle, turn, place), random, 2, 32), sample);
    ASSERT_TRUE(seen);
    const std::optional<SeenRange> range =
        range_by_size(one_camera(), *objects.find("triangle"), SeenMark(), &seen->pose);
    ASSERT_TRUE(range);
    within += std::abs(range->mm - cv::norm(place)) < 2 * range->spread_mm ? 1 : 0;
  }
  EXPECT_GE(within, 0.93 * tries);
}

TEST(Plane, AHardShadowAcrossTheSheetHidesNoOutline) {
  Random random(8);
  const LearnedSample sample = learned(square, random);
  cv::Mat1b image = filled(projected(square, turned_about({0, 0, 0.3}), {10, 5, 500}), random);
  // Six tenths of the light are gone to the left of the mark's middle.
  cv::Mat1b dark = image.colRange(0, 335);
  dark = dark * 0.4;
  const std::optional<Registered> seen = registered(image, sample);
  ASSERT_TRUE(seen);
  const cv::Point2d middle = projected({{0, 0}}, cv::Matx33d::eye(), {10, 5, 500}).front();
  EXPECT_LT(cv::norm(seen->fit.in_image({0, 0}) - middle), 0.4);
}

}  // namespace
}  // namespace pizarra::vision
