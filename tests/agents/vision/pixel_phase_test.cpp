// A mark in full view whose edges run along the pixels: where they fall between two, its blur reaches into what is
// taken for ground. It is seen all the same, wherever it goes.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

TEST(PixelPhase, HidesNoMark) {
  Random random(3);
  for (const std::string name : {"circle", "square", "cross", "triangle"}) {
    MarkTracker tracker(learned_cell());
    ASSERT_TRUE(tracker.add(*learned_cell().find(name)));
    Time now = {};
    int lost = 0;
    for (int frame = 0; frame < campaign(80, 240); ++frame) {
      const double along = 0.02 * frame + 2.5 * (frame % 2);
      bench::Scene scene;
      scene.noise = 5;
      scene.marks = {{.name = name, .centre = {128.5 - along, 120.4 + 0.5 * along}}};
      const cv::Mat left = draw(scene, bench::Side::left, random);
      const cv::Mat right = draw(scene, bench::Side::right, random);
      StereoSight sight(left, right, bench::scene_camera());
      now += 10ms;
      lost += tracker.update(sight, now).front().seen ? 0 : 1;
    }
    EXPECT_EQ(lost, 0) << name;
  }
}

}  // namespace
}  // namespace pizarra::vision
