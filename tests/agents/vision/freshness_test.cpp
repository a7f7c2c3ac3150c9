// A question is answered from a frame that was taken after it, at every rate and after every rest. While no frame comes
// nothing is told as seen.

#include <cstdio>

#include "tests/agents/vision/streaming_camera.hpp"
#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

const cv::Point3d here(-100, 0, 850);
const cv::Point3d there(60, 40, 850);

class Freshness : public Vision, public testing::WithParamInterface<int> {
 protected:
  Freshness() {
    life.reset();
    eyes.scene.faces = {{.mark = "circle", .place = here}};
    life.emplace(executor, board, eyes, &streams, VisionOptions{});
    const cv::Point2d at = project(eyes.model(), here, false);
    EXPECT_EQ(call(write(list("learn"_sym, at.x, at.y, "circle")), 60s), R"x((LEARN "circle" OK))x");
  }
  ~Freshness() override { life.reset(); }
  static Duration period() { return Duration(1'000'000 / GetParam()); }
  void move_there() { eyes.scene.faces[0].place = there; }
  void expect_there(const std::string& text, const std::string& format) const {
    double x = 0;
    double y = 0;
    const cv::Point2d at = project(eyes.model(), there, false);
    ASSERT_EQ(std::sscanf(text.c_str(), format.c_str(), &x, &y), 2) << text;
    EXPECT_NEAR(x, at.x, 3) << text;
    EXPECT_NEAR(y, at.y, 3) << text;
  }
  void expect_found_there() { expect_there(call("(find \"circle\")", 60s), R"x((FIND "circle" OK (%lf, %lf)))x"); }
  // What is told first.
  void expect_tracked_there() {
    EXPECT_EQ(call("(track \"circle\")", 60s), "()");
    while (says() == "nothing") run_for(5ms);
    expect_there(says(), R"x((TRACK 1 ("circle" OK (%lf, %lf)x");
  }
  void pass_a_frame() {
    const std::string ask = "(find \"circle\")";
    EXPECT_NE(call(ask, 60s).find("OK"), std::string::npos);
  }

  StreamingCamera eyes{executor, period()};
};

TEST_P(Freshness, WhatMovedJustAfterAFrameIsFoundWhereItIs) {
  pass_a_frame();
  run_for(3 * period() + 1ms);
  move_there();
  run_for(1ms);
  expect_found_there();
}

TEST_P(Freshness, WhatMovedWhileAFrameWasDecodedIsFoundAndTrackedWhereItIs) {
  eyes.decoding = period() / 2;
  EXPECT_EQ(call("(connect)"), "()");
  for (const bool tracks : {false, true}) {
    SCOPED_TRACE(tracks);
    eyes.scene.faces[0].place = here;
    run_for(3 * period());
    while (!eyes.is_decoding()) run_for(100us);
    move_there();
    tracks ? expect_tracked_there() : expect_found_there();
  }
}

TEST_P(Freshness, WhatMovedWhileTheEyesRestedIsFoundWhereItIs) {
  run_for(period() * 5 / 4);
  move_there();
  run_for(period() / 10);
  expect_found_there();
}

TEST_P(Freshness, WhatMovedWhileTheCameraHungIsFoundAndTrackedWhereItIs) {
  for (const bool tracks : {false, true}) {
    SCOPED_TRACE(tracks);
    eyes.scene.faces[0].place = here;
    eyes.hangs = false;
    run_for(2 * period());
    eyes.hangs = true;
    move_there();
    run_for(2500ms);
    const Time back = executor.now() + 500ms;
    executor.call_at(back, [&] { eyes.hangs = false; });
    tracks ? expect_tracked_there() : expect_found_there();
  }
}

TEST_P(Freshness, TrackingBeginsWithAFrameTakenAfterItWasAsked) {
  EXPECT_EQ(call("(connect)"), "()");
  run_for(period() * 5 / 4);
  move_there();
  expect_tracked_there();
}

TEST_P(Freshness, NothingIsToldAsSeenWhileNoFrameComes) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  const auto is_seen = [&] { return facts("(look vision ? ? ?)").find("\"circle\" seen") != std::string::npos; };
  while (!is_seen()) run_for(5ms);
  for (int i = 0; i < 20; ++i) {
    run_for(period());
    EXPECT_TRUE(is_seen());
  }
  const Time begun = executor.now();
  eyes.hangs = true;
  while (is_seen() && executor.now() < begun + 10s) run_for(1ms);
  EXPECT_LE(executor.now() - begun, 50ms + std::max<Duration>(100ms, 3 * period()));
  run_for(1s);
  EXPECT_FALSE(is_seen());
  eyes.hangs = false;
  const Time back = executor.now();
  while (!is_seen() && executor.now() < back + 10s) run_for(1ms);
  EXPECT_TRUE(is_seen());
}

INSTANTIATE_TEST_SUITE_P(AtRates, Freshness, testing::Values(1, 5, 30, 120));

}  // namespace
}  // namespace pizarra::vision
