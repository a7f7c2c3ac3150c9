// A shadow's edge passes over a mark that a pair follows: it hides nothing of it.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/agents/vision/falling_shadow.hpp"

namespace pizarra::vision {
namespace {

class Shadowed : public testing::TestWithParam<std::string> {
 protected:
  Shadowed() { EXPECT_TRUE(tracker_.add(*learned_cell().find(GetParam()))); }

  TrackSighting see(const std::optional<Shadow>& shadow) {
    const DrawnSight drawn(scene_, random_);
    const cv::Mat left = drawn.sight.left().clone();
    const cv::Mat right = drawn.sight.right().clone();
    if (shadow) shadow->fall(left, at(false));
    if (shadow) shadow->fall(right, at(true));
    StereoSight sight(left, right, DrawnSight::model());
    now_ += 100ms;
    return tracker_.update(sight, now_).front();
  }
  cv::Point2d at(bool right) const { return project(DrawnSight::model(), scene_.faces.front().place, right); }

  const Scene scene_{.faces = {{.mark = drawn_as(GetParam()), .place = {20, 10, 850}, .yaw_deg = 8}}};
  Random random_{5};
  Time now_ = {};
  MarkTracker tracker_{learned_cell()};
};

TEST_P(Shadowed, IsFollowedAsTheEdgePasses) {
  ASSERT_TRUE(see({}).seen);
  const double distance_mm = cv::norm(scene_.faces.front().place);
  int looks = 0;
  int seen = 0;
  for (const double from_deg : {0, 50, 90, 180, 230, 270}) {
    for (const double light : {0.4, 0.6, 0.75}) {
      for (int edge_px = 20; edge_px >= -20; edge_px -= 2) {
        const TrackSighting told = see(Shadow{from_deg, static_cast<double>(edge_px), light});
        ++looks;
        if (!told.seen) continue;
        ++seen;
        EXPECT_LT(cv::norm(told.centre - at(false)), 1) << from_deg << " degrees, " << edge_px << " px, " << light;
        EXPECT_NEAR(told.range_mm, distance_mm, 0.02 * distance_mm) << from_deg << " degrees, " << edge_px << " px";
      }
    }
  }
  EXPECT_GE(seen, 0.8 * looks);
}

INSTANTIATE_TEST_SUITE_P(Marks, Shadowed, testing::Values("circle", "square", "cross", "triangle"),
                         [](const auto& mark) { return mark.param; });

}  // namespace
}  // namespace pizarra::vision
