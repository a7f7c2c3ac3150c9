#include "agents/vision/marks/mark_patch.hpp"

#include <algorithm>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/image/bit_rows.hpp"
#include "agents/vision/image/light_map.hpp"

namespace pizarra::vision {
namespace {

constexpr int least_contrast = 20;
constexpr int large_px = 30;
constexpr double least_core_share = 0.85;    // of the mark's pixels, within a third of the contrast
constexpr double least_ground_share = 0.75;  // of the ground's around it, within a fifth, or within noise
constexpr double ground_noise = 2;           // so many of its standard deviations, up to a third of the contrast
constexpr double most_stray = 0.3;           // of the contrast: beyond it a ground pixel belongs to something else

// Of eight pixels: -1 for those whose bits are set.
using Mask = std::array<std::int16_t, 8>;

constexpr std::array<Mask, 256> masks = [] {
  std::array<Mask, 256> out{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    for (std::size_t i = 0; i < 8; ++i) out[bits][i] = (bits >> i & 1) != 0 ? -1 : 0;
  }
  return out;
}();

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
  out[0] = out[height - 1] = {};
  for (int y = 1; y < height - 1; ++y) {
    const BitRow<words> any = in[y - 1] | in[y] | in[y + 1];
    out[y] = any | any.shifted_left() | any.shifted_right();
  }
}

template <int words>
BitRow<words> shrunk(const Rows<words>& in, int y) {
  const BitRow<words> all = in[y - 1] & in[y] & in[y + 1];
  return all & all.shifted_left() & all.shifted_right();
}

// As seen in an image that begins at `origin` and has one pixel for so many along and across.
MarkContour reduced_contour(const MarkContour& contour, cv::Point origin, int reduction) {
  MarkContour out;
  for (const cv::Point& p : contour) {
    const cv::Point at = (p - origin) / reduction;
    if (out.empty() || at != out.back()) out.push_back(at);
  }
  return out;
}

}  // namespace

bool is_large_mark(cv::Rect box) { return std::max(box.width, box.height) > large_px; }

template <int words>
struct MarkPatch::Regions {
  Rows<words> inside;
  Rows<words> grown;   // by one pixel
  Rows<words> around;  // within two pixels, as far as blur spreads the mark
  // The outermost pixels around a clean mark are even ground.
  BitRow<words> ground(int y) const { return around[y].without(grown[y]); }
  BitRow<words> core(int y) const { return shrunk<words>(inside, y); }
};

// `pixels` are those of the patch; it begins at `corner` of what `contour` is in.
template <int words>
bool MarkPatch::cut_rows(cv::Mat1b& pixels, const MarkContour& contour, cv::Point corner, MarkTone tone, double noise) {
  Regions<words> regions;
  fill_inside<words>(contour, corner, size.height, regions.inside);
  grow<words>(regions.inside, size.height, regions.grown);
  grow<words>(regions.grown, size.height, regions.around);
  const bool is_large = is_large_mark(mark_box);
  if (is_large) even_light_out<words>(pixels, regions, tone);
  if (!measure_levels<words>(pixels, regions, tone, noise)) return false;
  write_values<words>(pixels, regions, tone);
  if (is_large) fill_core<words>(regions);
  return true;
}

template <int words>
void MarkPatch::even_light_out(cv::Mat1b& pixels, const Regions<words>& regions, MarkTone tone) const {
  LightMap light(size);
  for (int y = 1; y < size.height - 1; ++y) {
    const BitRow<words> lighter = tone == MarkTone::light ? regions.core(y) : regions.ground(y);
    lighter.for_each_run([&](int first, int end) { light.add(pixels.ptr<std::uint8_t>(y), y, first, end); });
  }
  light.divide_out(pixels);
}

template <int words>
bool MarkPatch::measure_levels(const cv::Mat1b& pixels, const Regions<words>& regions, MarkTone tone, double noise) {
  GreyLevels core;
  GreyLevels ground;
  for (int y = 1; y < size.height - 1; ++y) {
    const std::uint8_t* row = pixels.ptr<std::uint8_t>(y);
    // Half the rows tell the median as well.
    if (y % 2 == 0) regions.core(y).for_each_run([&](int first, int end) { core.add(row, first, end); });
    regions.ground(y).for_each([&](int x) { ground.add(row[x]); });
  }
  mark_level = core.median();
  ground_level = ground.median();
  contrast = tone == MarkTone::dark ? ground_level - mark_level : mark_level - ground_level;
  if (core.total() == 0 || contrast < least_contrast) return false;
  if (!core.are_near(mark_level, contrast / 3, least_core_share)) return false;
  const int ground_tolerance = std::max(contrast / 5, std::min(contrast / 3, cvRound(ground_noise * noise)));
  return ground.are_near(ground_level, ground_tolerance, least_ground_share);
}

// How far each pixel is from the ground towards the mark. Beyond the mark's border, what is too far off is another
// thing.
template <int words>
void MarkPatch::write_values(const cv::Mat1b& pixels, const Regions<words>& regions, MarkTone tone) {
  const auto all = [](int value) { return cv::v_setall_s16(static_cast<short>(value)); };
  const cv::v_int16x8 ground_all = all(ground_level);
  const cv::v_int16x8 sign_all = all(tone == MarkTone::dark ? -1 : 1);
  const cv::v_int16x8 stray = all(static_cast<int>(most_stray * contrast));
  const cv::v_int16x8 minus_stray = all(-static_cast<int>(most_stray * contrast));
  std::int16_t* last = values.data() + (size.height - 1) * stride;
  std::fill_n(values.data(), stride, std::int16_t{0});
  std::fill_n(last, stride, std::int16_t{0});
  const int row_length = stride;
  for (int y = 1; y < size.height - 1; ++y) {
    const std::uint8_t* levels = pixels.ptr<std::uint8_t>(y);  // beyond its end is the next row
    std::int16_t* out = values.data() + y * stride;
    for (int word = 0; word < words; ++word) {
      std::uint64_t within_bits = regions.grown[y].bits[word];
      std::uint64_t near_bits = regions.around[y].bits[word];
      const int end = std::min(64 * (word + 1), row_length);
      for (int x = 64 * word; x < end; x += 8, within_bits >>= 8, near_bits >>= 8) {
        const cv::v_int16x8 level = cv::v_reinterpret_as_s16(cv::v_load_expand(levels + x));
        const cv::v_int16x8 value = cv::v_mul_wrap(level - ground_all, sign_all);
        const cv::v_int16x8 clean = cv::v_max(cv::v_min(value, stray), minus_stray) == value;
        const cv::v_int16x8 within = cv::v_load(masks[within_bits & 255].data());
        const cv::v_int16x8 near = cv::v_load(masks[near_bits & 255].data());
        cv::v_store(out + x, value & (within | (near & clean)));
      }
    }
  }
}

template <int words>
void MarkPatch::fill_core(const Regions<words>& regions) {
  for (int y = 1; y < size.height - 1; ++y) {
    std::int16_t* row = values.data() + y * stride;
    regions.core(y).for_each_run(
        [&](int first, int end) { std::fill(row + first, row + end, static_cast<std::int16_t>(contrast)); });
  }
}

bool MarkPatch::cut(const ImageCut& from, const MarkContour& contour, MarkTone tone) {
  const cv::Mat1b& image = from.pixels;
  mark_box = box_of(contour);
  // G. Pick's theorem: lattice points within and on a polygon.
  const auto border = static_cast<int>(contour.size());
  area_px = static_cast<int>(std::abs(signed_area(contour)) / 2) + border / 2 + 1;
  const auto parts = [](int whole, int part) { return (whole + part - 1) / part; };
  reduction = parts(std::max(mark_box.width, mark_box.height), most_side_px - 2 * margin_px);
  origin = mark_box.tl() - reduction * cv::Point(margin_px, margin_px);
  size = {parts(mark_box.width, reduction) + 2 * margin_px, parts(mark_box.height, reduction) + 2 * margin_px};
  stride = (size.width + 7) / 8 * 8;
  const cv::Rect area(origin, size * reduction);
  if ((area & cv::Rect({0, 0}, image.size())) != area) return false;
  cv::Mat1b pixels = image(area);
  const auto cut_from = [&](const MarkContour& outline, cv::Point corner) {
    return size.width <= 64 ? cut_rows<1>(pixels, outline, corner, tone, from.noise)
                            : cut_rows<2>(pixels, outline, corner, tone, from.noise);
  };
  if (reduction > 1) {
    cv::resize(image(area), pixels, size, 0, 0, cv::INTER_AREA);
    return cut_from(reduced_contour(contour, origin, reduction), {});
  }
  if (is_large_mark(mark_box)) pixels = pixels.clone();
  return cut_from(contour, origin);
}

}  // namespace pizarra::vision
