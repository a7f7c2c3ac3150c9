// TRACK before one camera looks as thoroughly as FIND for what it does not follow: a shadow's edge across a mark that
// it has never seen before leaves no region of the mark's form.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/agents/vision/falling_shadow.hpp"

namespace pizarra::vision {
namespace {

class Lost : public testing::TestWithParam<std::string> {
 protected:
  const LearnedObject& object() const { return *learned_cell().find(GetParam()); }
  cv::Mat1b draw(double yaw_deg, const Shadow& shadow) {
    scene_.faces.front().yaw_deg = yaw_deg;
    cv::Mat1b out = DrawnSight(scene_, random_).sight.left().clone();
    shadow.fall(out, at());
    return out;
  }
  cv::Point2d at() const { return project(DrawnSight::model(), scene_.faces.front().place, false); }

  const camera::StereoModel alone_ = one_camera_of(DrawnSight::model());
  Scene scene_{.faces = {{.mark = drawn_as(GetParam()), .place = {20, 10, 700}}}};
  Random random_{7};
};

TEST_P(Lost, IsTrackedByOneCameraFromTheFirstFrameWhereFindFindsIt) {
  int looks = 0;
  int found = 0;
  int seen = 0;
  for (const double yaw_deg : {0, 20}) {
    for (int from_deg = 0; from_deg < 360; from_deg += 40) {
      for (const double edge_px : {-5, 0, 5}) {
        const cv::Mat1b left = draw(yaw_deg, {static_cast<double>(from_deg), edge_px, 0.45});
        StereoSight sight(left, cv::Mat1b::zeros(left.size()), alone_);
        ++looks;
        const Result<FoundMark> mark = MarkFinder(learned_cell()).find(sight, object(), Time(1s));
        // A triangle's lit part is one as well.
        if (!mark || cv::norm(mark->pair.left.centre - at()) > 1) continue;
        ++found;
        MarkTracker tracker(learned_cell());
        ASSERT_TRUE(tracker.add(object()));
        const TrackSighting told = tracker.update(sight, Time(1s)).front();
        EXPECT_TRUE(told.seen) << from_deg << " degrees, " << edge_px << " px, yaw " << yaw_deg;
        if (!told.seen) continue;
        ++seen;
        EXPECT_LT(cv::norm(told.centre - at()), 1) << from_deg << " degrees, " << edge_px << " px, yaw " << yaw_deg;
      }
    }
  }
  EXPECT_EQ(seen, found);
  EXPECT_GT(found, looks / 2);
}

INSTANTIATE_TEST_SUITE_P(Marks, Lost, testing::Values("circle", "square", "cross", "triangle"),
                         [](const auto& mark) { return mark.param; });

}  // namespace
}  // namespace pizarra::vision
