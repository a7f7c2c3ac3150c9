// Before one camera a window of a house may be as square as a learned mark. Its print is fainter than ink on paper.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_finder.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/bench/vision/outline.hpp"
#include "tests/bench/vision/scene.hpp"

namespace pizarra::vision {
namespace {

const cv::Point2d mark_place{110, 120};
const cv::Point2d other_place{235, 110};

class FaintPrint : public testing::TestWithParam<std::string> {
 protected:
  bench::Scene scene_with(cv::Point2d mark) const {
    bench::Scene out;
    out.marks = {{.name = GetParam(), .centre = mark, .turn_deg = 5}};
    return out;
  }
  // The mark, and the same shape beside it, printed so light.
  bench::Scene scene_beside(double level) const {
    bench::Scene out = scene_with(mark_place);
    const bench::Shape other =
        bench::placed(bench::mark_shape(GetParam()), other_place, bench::scale_at(bench::learning_depth_mm), 5);
    out.things = {{.shape = other, .level = level}};
    return out;
  }
  Result<FoundMark> find_in(const bench::Scene& scene, MarkFinder& finder, Random& random) const {
    camera::StereoModel model = bench::scene_camera();
    model.base_line_mm = 0;
    const cv::Mat image = draw(scene, bench::Side::left, random);
    StereoSight sight(image, cv::Mat::zeros(image.size(), image.type()), model);
    return finder.find(sight, *learned_cell().find(GetParam()), {});
  }
  Result<FoundMark> find_beside(double level, std::uint64_t seed) const {
    Random random(seed);
    MarkFinder finder(learned_cell());
    return find_in(scene_beside(level), finder, random);
  }
};

TEST_P(FaintPrint, BesideAMarkMakesItNoLessSure) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Result<FoundMark> found = find_beside(75, seed);
    ASSERT_TRUE(found);
    EXPECT_LT(cv::norm(found->pair.left.centre - mark_place), 0.5);
    EXPECT_GT(found->confidence, 0.9);
    EXPECT_EQ(found->elsewhere.size(), 1U);
  }
}

TEST_P(FaintPrint, AsBoldAsTheMarkMayBeIt) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const Result<FoundMark> found = find_beside(25, seed);
    ASSERT_TRUE(found);
    EXPECT_LT(found->confidence, 0.7);
  }
}

TEST_P(FaintPrint, WhereTheMarkWasBeforeHidesNoMarkElsewhere) {
  for (const double level : {75, 110}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(seed);
      Random random(seed);
      MarkFinder finder(learned_cell());
      ASSERT_TRUE(find_in(scene_with(other_place - cv::Point2d(30, 0)), finder, random));
      const Result<FoundMark> found = find_in(scene_beside(level), finder, random);
      ASSERT_TRUE(found) << level;
      EXPECT_LT(cv::norm(found->pair.left.centre - mark_place), 0.5) << level;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfShapes, FaintPrint, testing::Values("square", "circle", "cross"));

}  // namespace
}  // namespace pizarra::vision
