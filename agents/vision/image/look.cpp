#include "agents/vision/image/look.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <opencv2/core/hal/intrin.hpp>
#include <utility>
#include <vector>

namespace pizarra::vision {
namespace {

constexpr int rows_sampled = 12;
constexpr double quiet = 4.5;            // grey levels
constexpr double left_of_noise = 0.375;  // after smoothing

// Means of two, rounded up, are one instruction for sixteen pixels.
std::uint8_t mean(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a + b + 1) >> 1); }

// The mean of `here` and the mean of its two neighbours.
void average(const std::uint8_t* before, const std::uint8_t* here, const std::uint8_t* after, int count,
             std::uint8_t* __restrict out) {
  for (int x = 0; x < count; ++x) out[x] = mean(mean(before[x], after[x]), here[x]);
}

void average_along(const std::uint8_t* row, int first, int count, int width, std::uint8_t* out) {
  const std::uint8_t* at = row + first;
  const int begin = first == 0 ? 1 : 0;
  const int end = first + count == width ? count - 1 : count;
  average(at + begin - 1, at + begin, at + begin + 1, end - begin, out + begin);
  if (begin == 1) out[0] = mean(mean(at[0], at[1]), at[0]);
  if (end == count - 1) out[end] = mean(mean(at[end - 1], at[end]), at[end]);
}

cv::Mat1b smoothed(const cv::Mat& grey, cv::Rect area) {
  cv::Mat1b out(area.size());
  const auto width = static_cast<std::size_t>(area.width);
  std::vector<std::uint8_t> rows(3 * width);
  std::uint8_t* above = rows.data();
  std::uint8_t* here = above + width;
  std::uint8_t* below = here + width;
  const auto read = [&](int y, std::uint8_t* row) {
    const int inside = std::clamp(area.y + y, 0, grey.rows - 1);
    average_along(grey.ptr<std::uint8_t>(inside), area.x, area.width, grey.cols, row);
  };
  read(-1, above);
  read(0, here);
  for (int y = 0; y < area.height; ++y) {
    read(y + 1, below);
    average(above, here, below, area.width, out.ptr<std::uint8_t>(y));
    std::swap(above, here);
    std::swap(here, below);
  }
  return out;
}

// Of each pixel's distance from the line through its neighbours: an edge counts little, as it is long but thin.
int roughness_of(const std::uint8_t* row, int width) {
  constexpr int block = 8 * 64;  // 16 bits hold the sum of 64, at most 510 each
  int sum = 0;
  int x = 1;
  while (x + 8 < width) {
    cv::v_uint16x8 sums = cv::v_setzero_u16();
    for (const int end = std::min(x + block, width - 8); x < end; x += 8) {
      const cv::v_uint16x8 beside = cv::v_load_expand(row + x - 1) + cv::v_load_expand(row + x + 1);
      const cv::v_uint16x8 here = cv::v_load_expand(row + x);
      sums += cv::v_absdiff(beside, here + here);
    }
    sum += static_cast<int>(cv::v_reduce_sum(sums));
  }
  for (; x + 1 < width; ++x) sum += std::abs(row[x - 1] - 2 * row[x] + row[x + 1]);
  return sum;
}

}  // namespace

double noise_of(const cv::Mat& grey) {
  std::vector<int> rows;
  const int step = std::max(1, grey.rows / rows_sampled);
  for (int y = step / 2; y < grey.rows; y += step) {
    rows.push_back(roughness_of(grey.ptr<std::uint8_t>(y), grey.cols));
  }
  if (rows.empty() || grey.cols < 3) return 0;
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
  std::ranges::nth_element(rows, middle);
  // The weights 1 -2 1 make noise sqrt(6) times as large; a normal number is 0.8 deviations from 0 on average.
  return *middle / (1.954 * (grey.cols - 2));
}

ImageCut look_at(const cv::Mat& grey, cv::Rect area, double noise) {
  assert(grey.type() == CV_8UC1 && grey.cols >= 2 && area.width >= 2 && area.height >= 1);
  assert((area & cv::Rect(0, 0, grey.cols, grey.rows)) == area);
  if (noise <= quiet) return {grey(area), area.tl(), noise};
  return {smoothed(grey, area), area.tl(), noise * left_of_noise};
}

}  // namespace pizarra::vision
