// Shapes from 40 px across to three quarters of the image's height, dark and light, at every usual resolution and in
// uneven light: learned by a click, found elsewhere and followed.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/outline.hpp"

namespace pizarra::vision {
namespace {

enum class Light : std::uint8_t { even, slope, vignette, shadow };

struct Case {
  cv::Size image;
  std::string shape;
  double across_px;
  bool dark;
  Light light;

  std::string text() const {
    return fmt::format("{} of {} px, {}, in {}x{}, light {}", shape, across_px, dark ? "dark" : "light", image.width,
                       image.height, static_cast<int>(light));
  }
};

// How much light falls on a place; the shadow's edge passes the middle, a fiftieth of the width wide.
double light_at(const Case& one, int x, int y) {
  const double across = (x + 0.5) / one.image.width - 0.5;
  const double down = (y + 0.5) / one.image.height - 0.5;
  switch (one.light) {
    case Light::slope:
      return 1 - 0.5 * across;
    case Light::vignette:
      return 1.1 - 1.2 * (across * across + down * down);
    case Light::shadow:
      return 1 - 0.3 * std::clamp(50 * (across + 0.5 * down) + 0.5, 0.0, 1.0);
    case Light::even:
      break;
  }
  return 1;
}

cv::Mat1b picture(const Case& one, cv::Point2d centre, cv::RNG& random, double size = 1) {
  cv::Mat1f image(one.image, one.dark ? 195.F : 38.F);
  const bench::Shape shape = bench::placed(bench::mark_shape(one.shape), centre, size * one.across_px / 44, 7);
  bench::paint(image, shape, one.dark ? 30.F : 195.F);
  cv::GaussianBlur(image, image, {5, 5}, 0.9);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) image(y, x) *= static_cast<float>(light_at(one, x, y));
  }
  cv::Mat1f noise(one.image);
  random.fill(noise, cv::RNG::NORMAL, 0, 3);
  cv::Mat1b out;
  cv::Mat(image + noise).convertTo(out, CV_8U);
  return out;
}

camera::StereoModel camera(cv::Size image) {
  return {.width = image.width,
          .height = image.height,
          .focal_px = 0.87 * image.width,
          .centre_x_px = (image.width - 1) / 2.0,
          .centre_y_px = (image.height - 1) / 2.0,
          .base_line_mm = 0,
          .learned_at_mm = 500};
}

Result<LearnedSample> learn(const Case& one, cv::Point2d centre, cv::Point2d click, cv::RNG& random) {
  const LearnedObjects none;
  const camera::StereoModel model = camera(one.image);
  const cv::Mat1b pictures[] = {picture(one, centre, random), picture(one, centre, random)};
  MarkLearner learner("thing", click, none);
  for (int frame = 0; !learner.done(); ++frame) {
    StereoSight sight(pictures[frame % 2], pictures[frame % 2], model);
    const Result<void> fed = learner.feed(sight);
    if (!fed) return fail(fed);
  }
  return learner.sample();
}

cv::Point2d middle(const Case& one) { return {0.48 * one.image.width, 0.51 * one.image.height}; }

void expect_seen(const Case& one) {
  SCOPED_TRACE(one.text());
  cv::RNG random(7);
  const camera::StereoModel model = camera(one.image);
  const double unit = one.image.width / 320.0;
  // Beside the middle, as people click.
  const cv::Point2d click = middle(one) + 0.08 * one.across_px * cv::Point2d(1, 0.6);
  Result<LearnedSample> sample = learn(one, middle(one), click, random);
  ASSERT_TRUE(sample) << sample.error().symbol << ": " << sample.error().sentence;
  sample->number = 1;
  LearnedObjects objects;
  objects.add("thing", *sample);
  MarkTracker tracker(objects);
  ASSERT_TRUE(tracker.add(objects.all().front()));
  Time now = {};
  for (const double step : {0.0, 1.0, 2.5, 4.5}) {
    const cv::Point2d place = middle(one) + step * unit * cv::Point2d(2, -1);
    const cv::Mat1b seen = picture(one, place, random, 0.97);
    StereoSight sight(seen, seen, model);
    const std::optional<SeenPair> found = sight.find(objects, objects.all().front());
    ASSERT_TRUE(found) << "not found after " << step;
    EXPECT_LT(cv::norm(found->left.centre - place), std::max(0.3, 0.006 * one.across_px));
    const TrackSighting sighting = tracker.update(sight, now += 100ms).front();
    ASSERT_TRUE(sighting.seen) << "lost after " << step;
    EXPECT_LT(cv::norm(sighting.centre - place), std::max(0.3, 0.006 * one.across_px));
    EXPECT_NEAR(sighting.range_mm / 500, 1 / 0.97, 0.04);
  }
}

class Sizes : public testing::TestWithParam<cv::Size> {};

TEST_P(Sizes, FromFortyPixelsToThreeQuartersOfTheHeightAreLearnedFoundAndFollowed) {
  const char* shapes[] = {"circle", "square", "triangle", "cross"};
  std::size_t next = 0;
  for (const double across : {40.0, 0.2 * GetParam().height, 0.27 * GetParam().height, 0.35 * GetParam().height,
                              0.5 * GetParam().height, 0.6 * GetParam().height, 0.75 * GetParam().height}) {
    const bool small = GetParam().width < 1000;
    for (const Light light : {Light::even, Light::slope, Light::vignette, Light::shadow}) {
      // Of the largest pictures, which take longest, every third.
      if (small || next % 3 == 0) expect_seen({GetParam(), shapes[next % 4], across, next % 2 != 0, light});
      if (small) expect_seen({GetParam(), shapes[(next + 1) % 4], across, next % 2 == 0, light});
      ++next;
    }
    ++next;
  }
}

TEST_P(Sizes, ALargeShapeOfAPairHasItsRange) {
  const Case one{GetParam(), "cross", 0.4 * GetParam().height, true, Light::slope};
  camera::StereoModel model = camera(GetParam());
  model.base_line_mm = 30;
  cv::RNG random(3);
  const LearnedObjects none;
  LearnedObjects objects;
  for (const double size : {1.0, 1.1}) {
    SCOPED_TRACE(size);
    const double depth_mm = 200 / size;
    const cv::Point2d disparity(model.focal_px * model.base_line_mm / depth_mm, 0);
    const cv::Point2d place = middle(one) + cv::Point2d(0.05 * GetParam().width, 0);
    const cv::Mat1b left = picture(one, place, random, size);
    const cv::Mat1b right = picture(one, place - disparity, random, size);
    if (size == 1) {
      MarkLearner learner("thing", place, none);
      while (!learner.done()) {
        StereoSight sight(left, right, model);
        ASSERT_TRUE(learner.feed(sight));
      }
      LearnedSample sample = learner.sample();
      sample.number = 1;
      objects.add("thing", sample);
    }
    StereoSight sight(left, right, model);
    MarkTracker tracker(objects);
    ASSERT_TRUE(tracker.add(objects.all().front()));
    const TrackSighting seen = tracker.update(sight, Time()).front();
    ASSERT_TRUE(seen.seen);
    EXPECT_NEAR(seen.range_mm, range_mm(model, place, disparity.x), 0.01 * depth_mm);
    EXPECT_GT(seen.range_spread_mm, 0);
  }
}

TEST_P(Sizes, ALargeShapeThatTheBorderCutsIsRefusedAndSoIsTheGroundAroundIt) {
  const Case one{GetParam(), "square", 0.5 * GetParam().height, true, Light::even};
  cv::RNG random(5);
  const cv::Point2d cut(0.2 * one.across_px, middle(one).y);
  EXPECT_EQ(learn(one, cut, cut + cv::Point2d(0.45 * one.across_px, 0), random).error().symbol, "border");
  const cv::Point2d beside = middle(one) + cv::Point2d(0.6 * one.across_px, 0);
  EXPECT_EQ(learn(one, middle(one), beside, random).error().symbol, "background");
}

TEST_P(Sizes, AShapeThatIsTooLargeIsToldSo) {
  const Case one{GetParam(), "circle", 0.95 * GetParam().height, true, Light::even};
  cv::RNG random(5);
  EXPECT_EQ(learn(one, middle(one), middle(one), random).error().symbol, "too-large");
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Sizes,
                         testing::Values(cv::Size(200, 200), cv::Size(320, 240), cv::Size(640, 480),
                                         cv::Size(1280, 960)),
                         [](const auto& size) { return fmt::format("Width{}", size.param.width); });

}  // namespace
}  // namespace pizarra::vision
