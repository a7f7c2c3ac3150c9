#include "drivers/camera/video_camera.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/real_executor.hpp"
#include "tests/drivers/camera/fake_source.hpp"
#include "tests/run_task.hpp"

namespace pizarra {
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
  Result<StereoFrame> next(std::uint64_t after, bool colour = false) {
    return run(executor, camera.next(after, colour));
  }

  FakeDevice device;
  CameraSetup setup{
      .arrangement = CameraSetup::Arrangement::single, .sources = {CameraSource{}}, .calibration_file = {}};
  RealExecutor executor;
  VideoCamera camera{executor, setup, [this] { return sources(); }};
};

TEST_F(VideoCameraTest, OneCameraAloneIsAPairWithoutABaseLine) {
  const Result<StereoModel> model = open();
  ASSERT_TRUE(model) << model.error().sentence;
  EXPECT_TRUE(model->is_single());
  EXPECT_EQ(model->width, 320);
  const Result<StereoFrame> frame = next(0);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->left->channels, 1);
  EXPECT_EQ(frame->right->pixels, std::vector<std::uint8_t>(320 * 240, 0));
}

TEST_F(VideoCameraTest, FramesAreNumberedUpwardsAndMadeOfTheirMoment) {
  ASSERT_TRUE(open());
  std::uint64_t last = 0;
  Time captured{};
  for (int i = 0; i < 20; ++i) {
    const Result<StereoFrame> frame = next(last);
    ASSERT_TRUE(frame);
    EXPECT_GT(frame->number, last);
    EXPECT_GT(frame->captured, captured);
    EXPECT_LE(frame->captured, executor.now());
    last = frame->number;
    captured = frame->captured;
  }
}

TEST_F(VideoCameraTest, ColourIsMadeWhenAskedForAndGreyGoesOn) {
  ASSERT_TRUE(open());
  const Result<StereoFrame> coloured = next(0, true);
  ASSERT_TRUE(coloured);
  EXPECT_EQ(coloured->left->channels, 3);
  EXPECT_EQ(coloured->left->pixels.size(), 3u * 320 * 240);
  EXPECT_EQ(next(coloured->number)->left->channels, 1);
}

TEST_F(VideoCameraTest, WhoIsSlowSeesTheNewestAndWhatWasMissedIsCounted) {
  ASSERT_TRUE(open());
  const std::uint64_t first = next(0)->number;
  const Time later = executor.now() + 100ms;
  executor.call_at(later, [] {});
  executor.run_until([&] { return executor.now() > later; });
  const Result<StereoFrame> frame = next(first);
  ASSERT_TRUE(frame);
  EXPECT_GT(frame->number, first + 5);
  EXPECT_LT(executor.now() - frame->captured, 100ms);
  EXPECT_GT(camera.drops().late, 5u);
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
  std::uint64_t last = next(0)->number;
  device.plugged = false;
  Result<StereoFrame> frame = next(last);
  while (frame) {
    last = frame->number;
    frame = next(last);
  }
  EXPECT_EQ(frame.error().sentence, "the camera: fake gives no images");
  EXPECT_EQ(device.open_now, 0) << "it is let go";
  device.plugged = true;
  ASSERT_TRUE(open());
  EXPECT_GT(next(last)->number, last);
  EXPECT_EQ(device.open_now, 1);
}

TEST_F(VideoCameraTest, GarbageIsACorruptFrameEachAndTheNextGoodOneComes) {
  ASSERT_TRUE(open());
  const std::uint64_t last = next(0)->number;
  device.garbage = true;
  Result<StereoFrame> frame = next(last);
  while (frame) frame = next(frame->number);
  EXPECT_EQ(frame.error().symbol, "corrupt-frame");
  EXPECT_EQ(frame.error().sentence, "the camera: what fake gives is no image that can be read");
  device.garbage = false;
  frame = next(last);
  while (!frame) frame = next(last);
  EXPECT_GT(frame->number, last);
  EXPECT_GE(camera.drops().corrupt, 1u);
  EXPECT_EQ(device.opened, 1);
}

TEST_F(VideoCameraTest, ACameraThatHangsIsNotOpenUntilItAnswersAgain) {
  ASSERT_TRUE(open());
  std::uint64_t last = next(0)->number;
  device.hangs = true;
  Result<StereoFrame> frame = next(last);
  for (; frame; frame = next(last)) last = frame->number;
  EXPECT_EQ(frame.error().sentence, "no image came within 3 s");
  const Result<StereoModel> hung = open();
  device.hangs = false;
  device.hangs.notify_all();
  ASSERT_FALSE(hung);
  EXPECT_EQ(hung.error().sentence, "the camera hangs: what was asked of it before is not answered");
  ASSERT_TRUE(open());
  EXPECT_GT(next(last)->number, last);
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
  Result<StereoFrame> frame = next(0);
  while (frame) frame = next(frame->number);
  EXPECT_EQ(frame.error().sentence, "the camera's image is 640x240, and those before were 320x240");
  // The next trouble lies there: the camera is not healthy.
  while (next(1'000'000)) {
  }
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
  const Time deadline = executor.now() + 5s;
  executor.run_until([&] {
    executor.call_at(executor.now() + 1ms, [] {});
    return device.open_now == 0 || executor.now() > deadline;
  });
  EXPECT_EQ(device.open_now, 0);
}

}  // namespace
}  // namespace pizarra
