#include "agents/vision/image/regions.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/image/look.hpp"
#include "blackboard/time/random.hpp"

namespace pizarra::vision {
namespace {

TEST(BitRow, IsFilledBetweenFlipsAcrossItsWords) {
  BitRow<2> row{};
  for (const int x : {3, 9, 60, 100}) row.flip(x);
  row.fill_between_flips();
  std::vector<std::pair<int, int>> runs;
  row.for_each_run([&](int first, int end) { runs.emplace_back(first, end); });
  EXPECT_EQ(runs, (std::vector<std::pair<int, int>>{{3, 9}, {60, 100}}));
}

TEST(Regions, AreThoseThatOpenCvFinds) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    cv::Mat1b mask = cv::Mat1b::zeros(50, 150);
    BitImage bits(mask.cols, mask.rows);
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        if (random.below(100) >= 35) continue;
        mask(y, x) = 255;
        bits.row(y)[x / 64] |= std::uint64_t{1} << (x % 64);
      }
    }
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8);
    const std::vector<Region> regions = regions_of(bits);
    ASSERT_EQ(regions.size(), static_cast<std::size_t>(count - 1));
    for (const Region& region : regions) {
      const int label = labels.at<int>(region.start);
      EXPECT_EQ(region.area_px, stats.at<int>(label, cv::CC_STAT_AREA));
      EXPECT_EQ(region.box, cv::Rect(stats.at<int>(label, 0), stats.at<int>(label, 1), stats.at<int>(label, 2),
                                     stats.at<int>(label, 3)));
      EXPECT_EQ(region.start.y, region.box.y);
    }
  }
}

TEST(Look, EstimatesTheNoiseAndTakesFiveEighthsOfItAway) {
  Random random(4);
  for (const double noise : {2.0, 8.0, 15.0}) {
    cv::Mat1b image(240, 320);
    for (std::uint8_t& pixel : image) pixel = cv::saturate_cast<std::uint8_t>(120 + noise * random.normal());
    EXPECT_NEAR(noise_of(image), noise, 0.1 * noise);
    const ImageCut cut = look_at(image, {40, 30, 100, 90}, noise);
    cv::Scalar mean, deviation;
    cv::meanStdDev(cut.pixels, mean, deviation);
    EXPECT_NEAR(deviation[0], noise < 4 ? noise : 0.375 * noise, 0.1 * noise);
    EXPECT_NEAR(mean[0], 120, 1.5);
  }
}

}  // namespace
}  // namespace pizarra::vision
