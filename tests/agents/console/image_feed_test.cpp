// Which pictures are made, and for whom.

#include "agents/console/image_feed.hpp"

#include <gtest/gtest.h>
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
