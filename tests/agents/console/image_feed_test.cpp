// Which pictures are made, and for whom.

#include "agents/console/image_feed.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/camera/opencv_files.hpp"

namespace pizarra::console {
namespace {

using Size = ImageFeeds::Size;
using Pictures = std::vector<std::shared_ptr<const ImageFeeds::Picture>>;

class ImageFeedTest : public testing::Test {
 protected:
  std::unique_ptr<ImageFeeds::Look> look(Pictures& into, const std::string& stream = "eyes") {
    return feeds_.look(stream, [&into](const auto& picture) { into.push_back(picture); });
  }

  void publish(std::uint64_t number, int width = 640, int height = 480, const std::string& stream = "eyes") {
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->channels = 3;
    image->pixels.assign(static_cast<std::size_t>(width) * height * 3, 90);
    streams_.publish(stream, {.number = number, .captured = executor_.now(), .image = image});
  }

  // Edges and shades, as a camera shows them, with its noise.
  void publish_scene(int width, int height) {
    const cv::Scalar table(120, 140, 150);
    cv::Mat pixels(height, width, CV_8UC3, table);
    cv::RNG random(7);
    for (int i = 0; i < 40; ++i) {
      const cv::Point corner(random.uniform(0, width), random.uniform(0, height));
      const cv::Scalar colour(random.uniform(60, 200), random.uniform(60, 200), random.uniform(60, 200));
      cv::rectangle(pixels, cv::Rect(corner, cv::Size(width / 8, height / 8)), colour, cv::FILLED);
    }
    cv::Mat noise(pixels.size(), CV_8UC3);
    random.fill(noise, cv::RNG::NORMAL, 8, 2);
    pixels += noise;
    auto image = std::make_shared<Image>();
    image->width = width;
    image->height = height;
    image->channels = 3;
    image->pixels.assign(pixels.datastart, pixels.dataend);
    streams_.publish("eyes", {.number = 1, .captured = executor_.now(), .image = image});
  }

  // How long the work takes that there is.
  Duration work() {
    const Time begun = executor_.now();
    executor_.run_until([] { return false; });
    return executor_.now() - begun;
  }

  static cv::Size size_of(const ImageFeeds::Picture& picture) {
    const std::vector<unsigned char> bytes(picture.jpeg.begin(), picture.jpeg.end());
    return camera::opencv_files()->decode(bytes, false).size();
  }

  VirtualExecutor executor_;
  LocalStreams streams_;
  ImageFeeds feeds_{executor_, streams_};
};

TEST_F(ImageFeedTest, MakesOnePictureForAllWhoWantItInOneSize) {
  Pictures mine;
  Pictures yours;
  const auto my_look = look(mine);
  const auto your_look = look(yours);
  my_look->want(Size::full);
  your_look->want(Size::full);
  publish(1);
  const Duration once = work();
  EXPECT_GT(once, Duration(0));
  ASSERT_EQ(mine.size(), 1U);
  EXPECT_EQ(mine, yours);
  your_look->want(Size::light);
  publish(2);
  work();
  ASSERT_EQ(mine.size(), 2U);
  ASSERT_EQ(yours.size(), 2U);
  EXPECT_EQ(mine[1]->number, 2U);
  EXPECT_EQ(yours[1]->number, 2U);
  EXPECT_LT(yours[1]->jpeg.size(), mine[1]->jpeg.size());
}

TEST_F(ImageFeedTest, MakesNothingThatNobodyCanTake) {
  Pictures shown;
  const auto stalled = look(shown);
  publish(1);
  EXPECT_EQ(work(), Duration(0));
  stalled->want(Size::light);
  EXPECT_GT(work(), Duration(0));
  stalled->want(std::nullopt);
  publish(2);
  publish(3);
  EXPECT_EQ(work(), Duration(0));
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0]->number, 1U);
}

TEST_F(ImageFeedTest, ShowsTheNewestFrameToWhoCanTakeOneAgain) {
  Pictures busy;
  Pictures free;
  const auto busy_look = look(busy);
  const auto free_look = look(free);
  free_look->want(Size::full);
  publish(1);
  work();
  publish(2);
  work();
  busy_look->want(Size::full);
  EXPECT_EQ(work(), Duration(0)) << "it is there already";
  ASSERT_EQ(busy.size(), 1U);
  EXPECT_EQ(busy[0], free[1]);
  busy_look->want(std::nullopt);
  busy_look->want(Size::full);
  work();
  EXPECT_EQ(busy.size(), 1U) << "each frame is shown once";
}

TEST_F(ImageFeedTest, ShowsStreamsInTheOrderInWhichTheirFramesCame) {
  Pictures shown;
  const std::vector<std::string> streams{"eyes-annotated", "eyes-colour", "eyes-grey"};
  std::vector<std::unique_ptr<ImageFeeds::Look>> looks;
  for (const std::string& stream : streams) {
    looks.push_back(look(shown, stream));
    looks.back()->want(Size::light);
  }
  publish(1, 640, 480, streams[1]);
  publish(2, 640, 480, streams[0]);
  publish(3, 640, 480, streams[2]);
  work();
  ASSERT_EQ(shown.size(), 3U);
  for (std::uint64_t i = 0; i < 3; ++i) EXPECT_EQ(shown[i]->number, i + 1);
}

TEST_F(ImageFeedTest, KnowsOfALightPictureHowManyBytesAFullOneTakesAtMost) {
  struct Case {
    int width, height;
  };
  for (const Case& given : std::vector<Case>{{640, 480}, {1280, 720}, {320, 240}, {200, 150}}) {
    Pictures light;
    Pictures full;
    const auto light_look = look(light);
    const auto full_look = look(full);
    light_look->want(Size::light);
    full_look->want(Size::full);
    publish_scene(given.width, given.height);
    work();
    ASSERT_EQ(light.size(), 1U);
    ASSERT_EQ(full.size(), 1U);
    const std::size_t bytes = full[0]->jpeg.size();
    EXPECT_EQ(full[0]->full_bytes, bytes);
    EXPECT_GE(light[0]->full_bytes, bytes) << given.width;
    EXPECT_LE(light[0]->full_bytes, 5 * bytes) << given.width;
  }
}

TEST_F(ImageFeedTest, MakesLightPicturesOfTheirFramesShape) {
  Pictures shown;
  const auto looking = look(shown);
  looking->want(Size::light);
  struct Case {
    int width, height;
    cv::Size light;
  };
  for (const Case& given : std::vector<Case>{
           {640, 480, {240, 180}}, {1281, 721, {240, 135}}, {320, 240, {240, 180}}, {100, 80, {100, 80}}}) {
    publish(1, given.width, given.height);
    work();
    EXPECT_EQ(size_of(*shown.back()), given.light) << given.width;
    EXPECT_EQ(shown.back()->width, given.width);
  }
}

}  // namespace
}  // namespace pizarra::console
