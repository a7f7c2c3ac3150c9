// A lamp's reflection lies softly on a print: it makes ink grey, here more and there less, and hides nothing of it.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/level_regions.hpp"

namespace pizarra::vision {
namespace {

constexpr int radius_px = 27;
const cv::Point middle(60, 60);

// A disc whose ink is ever lighter from one side to the other, on paper as light as `paper`.
cv::Mat1b reflecting_disc(double from_deg, double darkest, double lightest, double paper) {
  cv::Mat1f image(120, 120, static_cast<float>(paper));
  const double from = from_deg * CV_PI / 180;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Point2d off = cv::Point2d(x, y) - cv::Point2d(middle);
      if (cv::norm(off) > radius_px) continue;
      const double along = (off.x * std::cos(from) + off.y * std::sin(from)) / radius_px;
      image(y, x) = static_cast<float>(std::lerp(darkest, lightest, (along + 1) / 2));
    }
  }
  cv::GaussianBlur(image, image, {}, 0.8);
  return image;
}

TEST(Reflection, LeavesTheWholePrintOneRegion) {
  const cv::Rect disc(middle.x - radius_px, middle.y - radius_px, 2 * radius_px + 1, 2 * radius_px + 1);
  for (const double lightest : {140, 170, 190}) {
    for (int from_deg = 0; from_deg < 360; from_deg += 15) {
      const cv::Mat1b image = reflecting_disc(from_deg, 60, lightest, 235);
      const std::vector<LevelRegion> regions = level_regions(image, MarkTone::dark, fine_steps);
      const bool is_whole = std::ranges::any_of(regions, [&](const LevelRegion& region) {
        const cv::Point off = region.box.tl() - disc.tl();
        const cv::Point beyond = region.box.br() - disc.br();
        return std::max({std::abs(off.x), std::abs(off.y), std::abs(beyond.x), std::abs(beyond.y)}) <= 1;
      });
      EXPECT_TRUE(is_whole) << "from " << from_deg << " degrees, up to " << lightest;
    }
  }
}

}  // namespace
}  // namespace pizarra::vision
