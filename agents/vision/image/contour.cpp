#include "agents/vision/image/contour.hpp"

#include <cstdint>
#include <opencv2/core/hal/intrin.hpp>

namespace pizarra::vision {
namespace {

constexpr std::size_t at_once = 4;

// Four points from this one on, x and y in turns. No image is so wide or high that 16 bits do not hold them.
cv::v_int16x8 four_from(const cv::Point* point) { return cv::v_pack(cv::v_load(&point[0].x), cv::v_load(&point[2].x)); }

}  // namespace

// Of every point its column times the rows from the one before it to the one after it. What overflows on the way comes
// back: the whole is no larger than the image.
long signed_area(const MarkContour& contour) {
  const std::size_t size = contour.size();
  if (size == 0) return 0;
  std::uint32_t sum = 0;
  const auto add = [&](std::size_t before, std::size_t here, std::size_t after) {
    sum += static_cast<std::uint32_t>(contour[here].x * (contour[after].y - contour[before].y));
  };
  cv::v_int32x4 sums = cv::v_setzero_s32();
  std::size_t i = 1;
  for (; i + at_once < size; i += at_once) {
    const cv::Point* here = contour.data() + i;
    const cv::v_int16x8 across = cv::v_sub_wrap(four_from(here + 1), four_from(here - 1));
    const cv::v_uint32x4 rows = cv::v_reinterpret_as_u32(across) >> 16;
    sums = cv::v_dotprod(four_from(here), cv::v_reinterpret_as_s16(rows), sums);
  }
  for (; i + 1 < size; ++i) add(i - 1, i, i + 1);
  if (size > 1) add(size - 2, size - 1, 0);
  add(size - 1, 0, size > 1 ? 1 : 0);
  return static_cast<std::int32_t>(sum + static_cast<std::uint32_t>(cv::v_reduce_sum(sums)));
}

cv::Rect box_of(const MarkContour& contour) {
  cv::Point low = contour.front();
  cv::Point high = low;
  const auto add = [&](const cv::Point& low_point, const cv::Point& high_point) {
    low = {std::min(low.x, low_point.x), std::min(low.y, low_point.y)};
    high = {std::max(high.x, high_point.x), std::max(high.y, high_point.y)};
  };
  std::size_t i = 0;
  if (contour.size() >= at_once) {
    cv::v_int16x8 lows = four_from(contour.data());
    cv::v_int16x8 highs = lows;
    for (; i + at_once <= contour.size(); i += at_once) {
      const cv::v_int16x8 four = four_from(contour.data() + i);
      lows = cv::v_min(lows, four);
      highs = cv::v_max(highs, four);
    }
    std::array<std::int16_t, 2 * at_once> least;
    std::array<std::int16_t, 2 * at_once> most;
    cv::v_store(least.data(), lows);
    cv::v_store(most.data(), highs);
    for (std::size_t k = 0; k < least.size(); k += 2) add({least[k], least[k + 1]}, {most[k], most[k + 1]});
  }
  for (; i < contour.size(); ++i) add(contour[i], contour[i]);
  return {low, high + cv::Point(1, 1)};
}

}  // namespace pizarra::vision
