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
  // The mark, and the same shape beside it, printed so light.
  Result<FoundMark> find_beside(double level, std::uint64_t seed) const {
    Random random(seed);
    bench::Scene scene;
    scene.marks = {{.name = GetParam(), .centre = mark_place, .turn_deg = 5}};
    const bench::Shape other =
        bench::placed(bench::mark_shape(GetParam()), other_place, bench::scale_at(bench::learning_depth_mm), 5);
    scene.things = {{.shape = other, .level = level}};
    camera::StereoModel model = bench::scene_camera();
    model.base_line_mm = 0;
    const cv::Mat image = draw(scene, bench::Side::left, random);
    StereoSight sight(image, cv::Mat::zeros(image.size(), image.type()), model);
    MarkFinder finder(learned_cell());
    return finder.find(sight, *learned_cell().find(GetParam()), {});
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

INSTANTIATE_TEST_SUITE_P(OfShapes, FaintPrint, testing::Values("square", "circle", "cross"));

}  // namespace
}  // namespace pizarra::vision
