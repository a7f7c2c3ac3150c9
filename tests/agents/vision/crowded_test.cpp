// More closed regions in the image than are looked at: specks keep no larger mark from being seen.

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {
namespace {

const cv::Size image_size(1280, 960);
constexpr int dark_grey = 40;
constexpr int light_grey = 190;

// Dots above, as wide as `dot_px`, and one square of 90 px below them.
cv::Mat1b dots_above_a_square(int dots, int dot_px, int square_level, int dot_level) {
  cv::Mat1b image(image_size, 115);
  for (int i = 0; i < dots; ++i) {
    const cv::Point middle(40 + i % 30 * 40, 40 + i / 30 * 40);
    cv::circle(image, middle, dot_px / 2, dot_level, cv::FILLED, cv::LINE_AA);
  }
  cv::rectangle(image, cv::Rect(505, 695, 90, 90), square_level, cv::FILLED);
  cv::GaussianBlur(image, image, {5, 5}, 0.8);
  return image;
}

const SeenMark* mark_at(ImageSegmentation& segmentation, cv::Point2d place) {
  for (const SeenMark& mark : segmentation.marks()) {
    if (cv::norm(mark.centre - place) < 2) return &mark;
  }
  return nullptr;
}

TEST(CrowdedImage, ALargeMarkIsSeenBelowManySpecks) {
  ImageSegmentation segmentation(dots_above_a_square(300, 16, dark_grey, dark_grey));
  EXPECT_NE(mark_at(segmentation, {549.5, 739.5}), nullptr);
  EXPECT_EQ(segmentation.marks().size(), most_marks);
  EXPECT_EQ(segmentation.left_out(), 301 - most_marks);
}

TEST(CrowdedImage, DarkSpecksKeepNoLightMarkFromBeingSeen) {
  ImageSegmentation segmentation(dots_above_a_square(300, 16, light_grey, dark_grey));
  const SeenMark* square = mark_at(segmentation, {549.5, 739.5});
  ASSERT_NE(square, nullptr);
  EXPECT_EQ(square->tone, MarkTone::light);
}

TEST(CrowdedImage, NothingIsLeftOutOfOneThatIsNot) {
  ImageSegmentation segmentation(dots_above_a_square(100, 16, dark_grey, dark_grey));
  EXPECT_EQ(segmentation.marks().size(), 101);
  EXPECT_EQ(segmentation.left_out(), 0);
}

camera::StereoModel one_camera() {
  return {.width = image_size.width, .height = image_size.height, .base_line_mm = 0, .learned_at_mm = 500};
}

std::string failure_of_learning(const cv::Mat1b& image, cv::Point2d click) {
  const LearnedObjects none;
  const camera::StereoModel model = one_camera();
  MarkLearner learner("thing", click, none);
  while (!learner.done()) {
    StereoSight sight(image, image, model);
    const Result<void> fed = learner.feed(sight);
    if (!fed) return fed.error().symbol;
  }
  return "none";
}

TEST(CrowdedImage, AMarkIsLearnedBelowSpecksAndASpeckAmongLargerOnesIsToldWhyNot) {
  EXPECT_EQ(failure_of_learning(dots_above_a_square(300, 16, dark_grey, dark_grey), {550, 740}), "none");
  cv::Mat1b image = dots_above_a_square(300, 24, dark_grey, dark_grey);
  cv::circle(image, {1000, 800}, 7, dark_grey, cv::FILLED, cv::LINE_AA);
  EXPECT_EQ(failure_of_learning(image, {1000, 800}), "crowded");
}

}  // namespace
}  // namespace pizarra::vision
