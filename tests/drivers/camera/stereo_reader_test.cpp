#include "drivers/camera/stereo_reader.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/camera/fake_source.hpp"

namespace pizarra::camera {
namespace {

class StereoReaderTest : public testing::Test {
 protected:
  StereoReader reader() {
    StereoReader::Sources sources;
    sources.push_back(std::make_unique<FakeSource>(left));
    if (setup.arrangement == forms::CameraSetup::Arrangement::pair)
      sources.push_back(std::make_unique<FakeSource>(right));
    return StereoReader(setup, std::move(sources), [this] { return now += 1ms; });
  }
  // The moments of the pair that grab() and retrieve() give, as the images' levels say.
  static std::pair<int, int> levels(StereoReader& eyes) {
    const Result<void> grabbed = eyes.grab();
    if (!grabbed) return {-1, -1};
    const Result<StereoImages> images = eyes.retrieve(false);
    if (!images) return {-2, -2};
    return {images->left.data[0], images->right.data[0]};
  }
  static std::string sentence(const auto& failed) { return failed ? "" : failed.error().sentence; }

  forms::CameraSetup setup{.arrangement = forms::CameraSetup::Arrangement::pair};
  FakeDevice left;
  FakeDevice right;
  Time now{};
};

TEST_F(StereoReaderTest, ImagesOfOneMomentMakeAPair) {
  left.moments_ms = {0, 33, 66};
  right.moments_ms = {2, 35, 68};
  StereoReader eyes = reader();
  ASSERT_TRUE(eyes.open());
  EXPECT_EQ(levels(eyes), std::pair(1, 1));
  EXPECT_EQ(levels(eyes), std::pair(2, 2));
  EXPECT_EQ(eyes.skewed(), 0u);
}

TEST_F(StereoReaderTest, AnImageWhosePartnerNeverCameIsLetGoAndCounted) {
  left.moments_ms = {0, 33, 66, 99};
  right.moments_ms = {33, 66, 99};
  StereoReader eyes = reader();
  ASSERT_TRUE(eyes.open());
  EXPECT_EQ(levels(eyes), std::pair(2, 1));
  EXPECT_EQ(levels(eyes), std::pair(3, 2));
  EXPECT_EQ(eyes.skewed(), 1u);
}

TEST_F(StereoReaderTest, TheAllowedSkewIsTheSetups) {
  left.moments_ms = {0, 33};
  right.moments_ms = {10, 33};
  setup.skew_ms = 5;
  StereoReader strict = reader();
  ASSERT_TRUE(strict.open());
  EXPECT_EQ(levels(strict), std::pair(2, 2));
  setup.skew_ms = 12;
  StereoReader lenient = reader();
  ASSERT_TRUE(lenient.open());
  EXPECT_EQ(levels(lenient), std::pair(1, 1));
}

TEST_F(StereoReaderTest, CamerasThatNeverMeetAreACorruptFrameThatSaysHowFarApart) {
  for (int i = 0; i < 40; ++i) left.moments_ms.push_back(33 * i);
  right.moments_ms = {100'000, 100'033};
  StereoReader eyes = reader();
  ASSERT_TRUE(eyes.open());
  const Result<void> grabbed = eyes.grab();
  ASSERT_FALSE(grabbed);
  EXPECT_EQ(grabbed.error().symbol, "corrupt-frame");
  EXPECT_NE(grabbed.error().sentence.find("ms apart"), std::string::npos) << grabbed.error().sentence;
}

TEST_F(StereoReaderTest, ARecordingThatIsOverBeginsAnewWithBothCameras) {
  left.moments_ms = {0, 100, 200};
  right.moments_ms = {0, 100};
  left.hz = right.hz = 10;
  StereoReader eyes = reader();
  ASSERT_TRUE(eyes.open());
  EXPECT_EQ(levels(eyes), std::pair(1, 1));
  EXPECT_EQ(levels(eyes), std::pair(2, 2));
  EXPECT_EQ(levels(eyes), std::pair(1, 1));
}

TEST_F(StereoReaderTest, OneCameraGivesBothHalvesOfItsImage) {
  setup.arrangement = forms::CameraSetup::Arrangement::side_by_side;
  left.width = 641;
  StereoReader eyes = reader();
  ASSERT_TRUE(eyes.open());
  ASSERT_TRUE(eyes.grab());
  const StereoImages images = eyes.retrieve(false).value();
  EXPECT_EQ(images.left.size(), cv::Size(320, 240));
  EXPECT_EQ(images.right.size(), cv::Size(320, 240));
}

TEST_F(StereoReaderTest, FailuresNameTheCamera) {
  right.plugged = false;
  StereoReader eyes = reader();
  EXPECT_EQ(sentence(eyes.open()), "the right camera: fake cannot be opened");
  right.plugged = true;
  ASSERT_TRUE(eyes.open());
  left.plugged = false;
  EXPECT_EQ(sentence(eyes.grab()), "the left camera: fake gives no images");
  setup.arrangement = forms::CameraSetup::Arrangement::single;
  EXPECT_EQ(sentence(reader().open()), "the camera: fake cannot be opened");
}

TEST_F(StereoReaderTest, ImagesOfOtherSizesAreRefused) {
  right.width = 640;
  StereoReader uneven = reader();
  ASSERT_TRUE(uneven.open());
  ASSERT_TRUE(uneven.grab());
  EXPECT_EQ(sentence(uneven.retrieve(false)), "the left camera's image is 320x240, the right one's 640x240");
  right.width = 320;
  setup.width = 640;
  setup.height = 480;
  StereoReader small = reader();
  ASSERT_TRUE(small.open());
  ASSERT_TRUE(small.grab());
  EXPECT_EQ(sentence(small.retrieve(false)), "the camera's image is 320x240, and 640x480 was asked for");
}

}  // namespace
}  // namespace pizarra::camera
