#include "drivers/camera/video_camera.hpp"

#include <gtest/gtest.h>
#include <thread>

#include "blackboard/time/real_executor.hpp"
#include "tests/drivers/camera/fake_source.hpp"
#include "tests/run_task.hpp"

namespace pizarra::camera {
namespace {

// Its images come 200 times a second.
class VideoCameraTest : public testing::Test {
 protected:
  VideoCameraTest() {
    device.hz = 200;
    for (int i = 0; i < 1000; ++i) device.moments_ms.push_back(5 * i);
  }
  StereoReader::Sources sources() {
    StereoReader::Sources out;
    out.push_back(std::make_unique<FakeSource>(device));
    return out;
  }
  Result<StereoModel> open() { return run(executor, camera.open()); }
  Result<StereoFrame> next(Time after, bool colour = false) { return run(executor, camera.next(after, colour)); }
  void run_for(Duration duration) {
    const Time end = executor.now() + duration;
    executor.call_at(end, [] {});
    executor.run_until([&] { return executor.now() >= end; });
  }
  // Five seconds at most.
  void wait_until(const std::function<bool()>& done) {
    const Time deadline = executor.now() + 5s;
    while (!done() && executor.now() < deadline) run_for(1ms);
    EXPECT_TRUE(done());
  }

  FakeDevice device;
  forms::CameraSetup setup{.arrangement = forms::CameraSetup::Arrangement::single,
                           .sources = {forms::CameraSource{}},
                           .calibration_file = {}};
  RealExecutor executor;
  VideoCamera camera{executor, setup, [this] { return sources(); }};
};

TEST_F(VideoCameraTest, OneCameraAloneIsAPairWithoutABaseLine) {
  const Result<StereoModel> model = open();
  ASSERT_TRUE(model) << model.error().sentence;
  EXPECT_TRUE(model->is_single());
  EXPECT_EQ(model->width, 320);
  const Result<StereoFrame> frame = next({});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->left->channels, 1);
  EXPECT_EQ(frame->right->pixels, std::vector<std::uint8_t>(320 * 240, 0));
}

TEST_F(VideoCameraTest, FramesAreNumberedUpwardsAndMadeOfTheirMoment) {
  ASSERT_TRUE(open());
  StereoFrame last;
  for (int i = 0; i < 20; ++i) {
    const Result<StereoFrame> frame = next(last.captured);
    ASSERT_TRUE(frame);
    EXPECT_GT(frame->number, last.number);
    EXPECT_GT(frame->captured, last.captured);
    EXPECT_LE(frame->captured, executor.now());
    last = *frame;
  }
}

TEST_F(VideoCameraTest, ColourIsMadeWhenAskedForAndGreyGoesOn) {
  ASSERT_TRUE(open());
  const Result<StereoFrame> coloured = next({}, true);
  ASSERT_TRUE(coloured);
  EXPECT_EQ(coloured->left->channels, 3);
  EXPECT_EQ(coloured->left->pixels.size(), 3u * 320 * 240);
  EXPECT_EQ(next(coloured->captured)->left->channels, 1);
}

TEST_F(VideoCameraTest, WhoIsSlowSeesTheNewestAndWhatWasMissedIsCounted) {
  ASSERT_TRUE(open());
  // Of those before the first one some were late as well.
  run_for(50ms);
  const StereoFrame first = *next({});
  const std::uint64_t late_before = camera.drops().late;
  wait_until([&] { return camera.drops().late > late_before + 5; });
  const std::uint64_t missed = camera.drops().late - late_before;
  ASSERT_GT(missed, 5U);
  const Result<StereoFrame> frame = next(first.captured);
  ASSERT_TRUE(frame);
  EXPECT_GE(frame->number, first.number + missed);
}

TEST_F(VideoCameraTest, ACameraThatIsNotThereIsSaidSoAndFoundWhenItComes) {
  device.plugged = false;
  const Result<StereoModel> missing = open();
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().symbol, "disconnected");
  EXPECT_EQ(missing.error().sentence, "the camera: fake cannot be opened");
  device.plugged = true;
  EXPECT_TRUE(open());
}

TEST_F(VideoCameraTest, ACameraThatDisappearsIsToldAndGoesOnAboveItsLastNumberWhenItReturns) {
  ASSERT_TRUE(open());
  StereoFrame last = *next({});
  device.plugged = false;
  Result<StereoFrame> frame = next(last.captured);
  while (frame) {
    last = *frame;
    frame = next(last.captured);
  }
  EXPECT_EQ(frame.error().sentence, "the camera: fake gives no images");
  EXPECT_EQ(device.open_now, 0) << "it is let go";
  device.plugged = true;
  ASSERT_TRUE(open());
  EXPECT_GT(next(last.captured)->number, last.number);
  EXPECT_EQ(device.open_now, 1);
}

TEST_F(VideoCameraTest, GarbageIsLeftOutAndSaidAndTheNextGoodImageComes) {
  ASSERT_TRUE(open());
  const StereoFrame last = *next({});
  device.garbage_left = 5;
  wait_until([&] { return device.garbage_left == 0; });
  const Result<StereoFrame> frame = next(executor.now());
  ASSERT_TRUE(frame);
  EXPECT_GT(frame->number, last.number + 5);
  EXPECT_EQ(camera.drops().corrupt, 5u);
  EXPECT_EQ(camera.drops().why_corrupt, "the camera: what fake gives is no image that can be read");
  EXPECT_EQ(device.opened, 1);
}

// However many look at its images meanwhile.
TEST_F(VideoCameraTest, TwentyGarbledImagesInARowAreTheEnd) {
  ASSERT_TRUE(open());
  const auto watch = [&](bool colour) -> Task<void> {
    Time after = {};
    Result<StereoFrame> frame = co_await camera.next(after, colour);
    while (frame) {
      after = frame->captured;
      frame = co_await camera.next(after, colour);
    }
    EXPECT_EQ(frame.error().symbol, "disconnected");
    EXPECT_EQ(frame.error().sentence, "the camera: what fake gives is no image that can be read");
  };
  const Job grey = executor.spawn(watch(false));
  const Job colour = executor.spawn(watch(true));
  wait_until([&] { return device.retrieved > 10; });
  device.garbage = true;
  executor.run_until([&] { return grey.done() && colour.done(); });
  EXPECT_EQ(camera.drops().corrupt, 20u);
  EXPECT_EQ(device.open_now, 0) << "it is let go";
}

TEST_F(VideoCameraTest, WhatIsAskedAfterARestIsAnsweredByAFrameOfAfterwards) {
  ASSERT_TRUE(open());
  ASSERT_TRUE(next({}));
  device.hangs = true;
  run_for(300ms);
  const Time asked = executor.now();
  executor.call_at(asked + 200ms, [this] {
    device.hangs = false;
    device.hangs.notify_all();
  });
  ASSERT_TRUE(open());
  const Result<StereoFrame> frame = next(asked);
  ASSERT_TRUE(frame);
  EXPECT_GE(frame->captured, asked + 200ms);
}

TEST_F(VideoCameraTest, ACameraThatHangsIsNotOpenUntilItAnswersAgain) {
  ASSERT_TRUE(open());
  StereoFrame last = *next({});
  device.hangs = true;
  Result<StereoFrame> frame = next(last.captured);
  for (; frame; frame = next(last.captured)) last = *frame;
  EXPECT_EQ(frame.error().sentence, "no image came within 3 s");
  const Result<StereoModel> hung = open();
  device.hangs = false;
  device.hangs.notify_all();
  ASSERT_FALSE(hung);
  EXPECT_EQ(hung.error().sentence, "the camera hangs: what was asked of it before is not answered");
  ASSERT_TRUE(open());
  EXPECT_GT(next(last.captured)->number, last.number);
}

TEST_F(VideoCameraTest, ADeviceThatNeverAnswersHoldsUpNobodysEnd) {
  const auto stuck = std::make_shared<FakeDevice>();  // the thread that waits for it stays
  stuck->hz = 200;
  const auto begun = std::chrono::steady_clock::now();
  {
    RealExecutor ending;
    VideoCamera hung(ending, setup, [stuck] {
      StereoReader::Sources out;
      out.push_back(std::make_unique<FakeSource>(*stuck));
      return out;
    });
    ASSERT_TRUE(run(ending, hung.open()));
    stuck->hangs = true;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 2s);
  stuck->hangs = false;
  stuck->hangs.notify_all();
  // A thread that still works on an image while the program ends finds OpenCV's storage gone.
  while (stuck.use_count() > 1) std::this_thread::yield();
}

TEST_F(VideoCameraTest, WhereAllIsGarbageOpeningSaysSoAfterTwentyImages) {
  device.garbage = true;
  const Time begun = executor.now();
  const Result<StereoModel> model = open();
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().sentence, "the camera: what fake gives is no image that can be read");
  EXPECT_LT(executor.now() - begun, 5s);
}

TEST_F(VideoCameraTest, ImagesThatChangeTheirSizeAreRefusedUntilTheCameraIsOpenedAnew) {
  ASSERT_TRUE(open());
  device.width = 640;
  Result<StereoFrame> frame = next({});
  while (frame) frame = next(frame->captured);
  EXPECT_EQ(frame.error().sentence, "the camera's image is 640x240, and those before were 320x240");
  const Result<StereoModel> again = open();
  ASSERT_TRUE(again);
}

TEST_F(VideoCameraTest, ASetupThatCannotBeUsedIsToldByOpen) {
  setup.calibration_file = "/nowhere.calibration";
  VideoCamera blurred(executor, setup, [this] { return sources(); });
  const Result<StereoModel> model = run(executor, blurred.open());
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().sentence.find("/nowhere.calibration"), std::string::npos) << model.error().sentence;
}

TEST_F(VideoCameraTest, ItIsLetGoWithItsUser) {
  {
    VideoCamera own(executor, setup, [this] { return sources(); });
    ASSERT_TRUE(run(executor, own.open()));
    EXPECT_EQ(device.open_now, 1);
  }
  wait_until([&] { return device.open_now == 0; });
  EXPECT_EQ(device.open_now, 0);
}

}  // namespace
}  // namespace pizarra::camera
