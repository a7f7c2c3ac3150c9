#include "agents/vision/marks/mark_patch.hpp"

#include <algorithm>
#include <opencv2/core/hal/intrin.hpp>

#include "agents/vision/image/bit_rows.hpp"

namespace pizarra {
namespace {

constexpr int least_contrast = 20;
constexpr double least_core_share = 0.85;    // of the mark's pixels, within a third of the contrast
constexpr double least_ground_share = 0.75;  // of the ground's around it, within a fifth
constexpr double most_stray = 0.3;           // of the contrast: beyond it a ground pixel belongs to something else

// The median of some pixels, and which share of them lies near it.
class Levels {
 public:
  void add(const std::uint8_t* row, int first, int end) {
    for (int x = first; x < end; ++x) ++counts_[row[x]];
    total_ += end - first;
  }
  int total() const { return total_; }
  int median() const {
    int level = 0;
    int seen = 0;
    // Whole blocks first: their sums are quick.
    while (level + block < 256 && 2 * (seen + sum_of_block(level)) < total_) {
      seen += sum_of_block(level);
      level += block;
    }
    while (level < 255 && 2 * (seen += counts_[static_cast<std::size_t>(level)]) < total_) ++level;
    return level;
  }
  bool are_near(int level, int tolerance, double share) const {
    int near = 0;
    for (int i = std::max(0, level - tolerance); i <= std::min(255, level + tolerance); ++i) {
      near += counts_[static_cast<std::size_t>(i)];
    }
    return near >= share * total_;
  }

 private:
  static constexpr int block = 16;
  int sum_of_block(int first) const {
    std::uint16_t sum = 0;
    for (int i = first; i < first + block; ++i) sum += counts_[static_cast<std::size_t>(i)];
    return sum;
  }

  std::array<std::uint16_t, 256> counts_{};
  int total_ = 0;
};

// Of eight pixels: -1 for those whose bits are set.
using Mask = std::array<std::int16_t, 8>;

const std::array<Mask, 256>& masks() {
  static constexpr auto table = [] {
    std::array<Mask, 256> out{};
    for (std::size_t bits = 0; bits < 256; ++bits) {
      for (std::size_t i = 0; i < 8; ++i) out[bits][i] = (bits >> i & 1) != 0 ? -1 : 0;
    }
    return out;
  }();
  return table;
}

template <int words>
using Rows = std::array<BitRow<words>, MarkPatch::most_side_px>;

// What the contour encloses, itself included: between flips at every crossing, and its own pixels.
template <int words>
void fill_inside(const MarkContour& contour, cv::Point origin, int height, Rows<words>& inside) {
  Rows<words> border;
  for (int y = 0; y < height; ++y) inside[y] = border[y] = {};
  cv::Point before = contour.back() - origin;
  for (const cv::Point& p : contour) {
    const cv::Point at = p - origin;
    border[at.y].set(at.x);
    if (at.y > before.y) inside[before.y].flip(before.x);
    if (at.y < before.y) inside[at.y].flip(at.x);
    before = at;
  }
  for (int y = 0; y < height; ++y) {
    inside[y].fill_between_flips();
    inside[y] = inside[y] | border[y];
  }
}

// Grown, or shrunk, by one pixel in all eight directions. The first and the last row stay empty.
template <int words>
void grow(const Rows<words>& in, int height, Rows<words>& out) {
  const auto wide = [&](int y) { return in[y] | in[y].shifted_left() | in[y].shifted_right(); };
  out[0] = out[height - 1] = {};
  BitRow<words> above = wide(0);
  BitRow<words> here = wide(1);
  for (int y = 1; y < height - 1; ++y) {
    const BitRow<words> below = wide(y + 1);
    out[y] = above | here | below;
    above = here;
    here = below;
  }
}

template <int words>
BitRow<words> shrunk(const Rows<words>& in, int y) {
  const auto narrow = [&](int i) { return in[i] & in[i].shifted_left() & in[i].shifted_right(); };
  return narrow(y - 1) & narrow(y) & narrow(y + 1);
}

}  // namespace

template <int words>
bool MarkPatch::cut_rows(const cv::Mat1b& image, const MarkContour& contour, MarkTone tone) {
  Rows<words> inside;
  Rows<words> grown;
  Rows<words> around;  // within two pixels, as far as blur spreads the mark; the second is even ground on a clean mark
  fill_inside<words>(contour, box.tl(), box.height, inside);
  grow<words>(inside, box.height, grown);
  grow<words>(grown, box.height, around);

  Levels core;
  Levels ground;
  for (int y = 1; y < box.height - 1; ++y) {
    const std::uint8_t* pixels = image.ptr<std::uint8_t>(box.y + y) + box.x;
    // Half the rows tell the median as well.
    if (y % 2 == 0) shrunk<words>(inside, y).for_each_run([&](int first, int end) { core.add(pixels, first, end); });
    around[y].without(grown[y]).for_each_run([&](int first, int end) { ground.add(pixels, first, end); });
  }
  mark_level = core.median();
  ground_level = ground.median();
  const int sign = tone == MarkTone::dark ? -1 : 1;
  contrast = sign * (mark_level - ground_level);
  if (core.total() == 0 || contrast < least_contrast) return false;
  if (!core.are_near(mark_level, contrast / 3, least_core_share)) return false;
  if (!ground.are_near(ground_level, contrast / 5, least_ground_share)) return false;

  const auto all = [](int value) { return cv::v_setall_s16(static_cast<short>(value)); };
  const cv::v_int16x8 ground_all = all(ground_level);
  const cv::v_int16x8 sign_all = all(sign);
  const cv::v_int16x8 stray = all(static_cast<int>(most_stray * contrast));
  const cv::v_int16x8 minus_stray = all(-static_cast<int>(most_stray * contrast));
  std::array<std::uint8_t, most_side_px + 8> line{};
  for (int y = 0; y < box.height; ++y) {
    std::copy_n(image.ptr<std::uint8_t>(box.y + y) + box.x, box.width, line.begin());
    for (int x = 0; x < stride; x += 8) {
      const cv::v_int16x8 pixels = cv::v_reinterpret_as_s16(cv::v_load_expand(line.data() + x));
      const cv::v_int16x8 value = cv::v_mul_wrap(pixels - ground_all, sign_all);
      const cv::v_int16x8 clean = (value <= stray) & (value >= minus_stray);
      const cv::v_int16x8 within = cv::v_load(masks()[grown[y].byte(x)].data());
      const cv::v_int16x8 near = cv::v_load(masks()[around[y].byte(x)].data());
      cv::v_store(values.data() + y * stride + x, value & (within | (near & clean)));
    }
  }
  return true;
}

bool MarkPatch::cut(const cv::Mat1b& image, const MarkContour& contour, MarkTone tone) {
  cv::Point low = contour.front();
  cv::Point high = contour.front();
  for (const cv::Point& p : contour) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  // G. Pick's theorem: lattice points within and on a polygon.
  const auto border = static_cast<int>(contour.size());
  area_px = static_cast<int>(std::abs(signed_area(contour)) / 2) + border / 2 + 1;
  const cv::Point margin(margin_px, margin_px);
  box = {low - margin, high + margin + cv::Point(1, 1)};
  if ((box & cv::Rect(0, 0, image.cols, image.rows)) != box) return false;
  if (box.width > most_side_px || box.height > most_side_px) return false;
  stride = (box.width + 7) / 8 * 8;
  return box.width <= 64 ? cut_rows<1>(image, contour, tone) : cut_rows<2>(image, contour, tone);
}

}  // namespace pizarra
