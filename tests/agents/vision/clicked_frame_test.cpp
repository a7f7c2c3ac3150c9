// A click belongs to the frame that was clicked on, however the picture has moved on since.

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

class ClickedFrame : public Vision {
 protected:
  const cv::Point3d here{-100, 0, 850};
  const cv::Point3d there{-100, 110, 850};

  ClickedFrame() {
    EXPECT_EQ(call("(connect)"), "()");
    run_for(1s);
  }
  ~ClickedFrame() override { life.reset(); }

  void move(const cv::Point3d& place) { camera.scene.faces[0].place = place; }
  std::int64_t newest_frame() {
    std::uint64_t number = 0;
    const auto look = streams.subscribe("vision-left", [&](const StreamFrame& frame) { number = frame.number; });
    run_for(150ms);
    return static_cast<std::int64_t>(number);
  }
  std::string learn_at(std::int64_t frame, const std::string& name) {
    const cv::Point2d at = project(camera.model(), here, false);
    return write(list("learn"_sym, at.x, at.y, frame, name));
  }
};

TEST_F(ClickedFrame, WhatWasClickedOnIsLearnedAlthoughItIsElsewhereNow) {
  const std::int64_t clicked = newest_frame();
  // It goes its way in steps that eyes can follow, long before anybody asks.
  for (int step = 1; step <= 20; ++step) {
    move(here + (there - here) * (step / 20.0));
    run_for(100ms);
  }
  EXPECT_EQ(call(learn_request(0, "late")), R"x((LEARN "late" OK))x") << "where it is now it can be learned";
  EXPECT_EQ(call("(reject \"late\")"), "()");
  EXPECT_EQ(call(write(list("learn"_sym, project(camera.model(), here, false).x, project(camera.model(), here, false).y,
                            "ground"))),
            R"x((LEARN "ground" FAIL))x")
      << "where it was there is nothing now";
  EXPECT_EQ(call(learn_at(clicked, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_NE(call("(find \"circle\")").find("OK"), std::string::npos);
}

TEST_F(ClickedFrame, OneThatWasAskedForAtOnceSeesTheFramesThatFollow) {
  const std::int64_t clicked = newest_frame();
  EXPECT_EQ(call(learn_at(clicked, "circle")), R"x((LEARN "circle" OK))x");
}

TEST_F(ClickedFrame, OneThatIsKeptNoMoreIsRefusedInWords) {
  const std::int64_t clicked = newest_frame();
  run_for(25s);
  EXPECT_EQ(call(learn_at(clicked, "circle")), R"x((LEARN "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ?f ?t frame-gone ?s)"), "");
  EXPECT_EQ(call(learn_at(1'000'000, "circle")), R"x((LEARN "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ?f ?t frame-gone ?s)"), "");
}

TEST_F(ClickedFrame, AnothersNumbersAreNotKeptOverANewCamera) {
  const std::int64_t clicked = newest_frame();
  camera.plugged = false;
  run_for(1s);
  camera.plugged = true;
  run_for(6s);
  EXPECT_EQ(call(learn_at(clicked, "circle")), R"x((LEARN "circle" FAIL))x");
}

}  // namespace
}  // namespace pizarra::vision
