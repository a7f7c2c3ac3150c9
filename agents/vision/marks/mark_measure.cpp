#include "agents/vision/marks/mark_measure.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/hal/intrin.hpp>

#include "agents/vision/marks/covariance.hpp"

namespace pizarra::vision {
namespace {

// Of the patch's values, about its left upper corner: sums are exact.
struct Sums {
  double s, x, y, xx, xy, yy;
};

// Of eight columns: the sums of their values, of these times the row, and times its square. 32 bits hold each.
struct ColumnSums {
  std::array<std::int32_t, 8> s, y, yy;
};

// Two numbers of 16 bits each, of every second row and the one after it: the rows themselves, and their squares.
struct RowPairs {
  std::array<std::int32_t, MarkPatch::most_side_px> rows, squares;
};

constexpr RowPairs row_pairs = [] {
  RowPairs out{};
  for (int row = 0; row < MarkPatch::most_side_px; ++row) {
    const int next = row + 1;
    out.rows[static_cast<std::size_t>(row)] = next << 16 | row;
    out.squares[static_cast<std::size_t>(row)] = next * next << 16 | row * row;
  }
  return out;
}();

ColumnSums column_sums(const MarkPatch& patch, int column) {
  cv::v_int32x4 s[2], y[2], yy[2];
  for (cv::v_int32x4* sum : {s, y, yy}) sum[0] = sum[1] = cv::v_setzero_s32();
  const auto in_all = [](std::int32_t pair) { return cv::v_reinterpret_as_s16(cv::v_setall_s32(pair)); };
  const cv::v_int16x8 ones = cv::v_setall_s16(1);
  // The first row is 0, and so is the last, with which those of an odd height end.
  for (int row = 1; row < patch.size.height - 1; row += 2) {
    const cv::v_int16x8 rows = in_all(row_pairs.rows[static_cast<std::size_t>(row)]);
    const cv::v_int16x8 squares = in_all(row_pairs.squares[static_cast<std::size_t>(row)]);
    cv::v_int16x8 pairs[2];
    cv::v_zip(cv::v_load(patch.row(row) + column), cv::v_load(patch.row(row + 1) + column), pairs[0], pairs[1]);
    for (int half = 0; half < 2; ++half) {
      s[half] += cv::v_dotprod(pairs[half], ones);
      y[half] += cv::v_dotprod(pairs[half], rows);
      yy[half] += cv::v_dotprod(pairs[half], squares);
    }
  }
  ColumnSums out;
  for (int half = 0; half < 2; ++half) {
    cv::v_store(out.s.data() + 4 * half, s[half]);
    cv::v_store(out.y.data() + 4 * half, y[half]);
    cv::v_store(out.yy.data() + 4 * half, yy[half]);
  }
  return out;
}

// Exact: what a double cannot hold no patch adds up to.
Sums sums_of(const MarkPatch& patch) {
  cv::v_float64x2 s = cv::v_setzero_f64();
  cv::v_float64x2 x = s, y = s, xx = s, xy = s, yy = s;
  const cv::v_float64x2 two = cv::v_setall_f64(2);
  cv::v_float64x2 column(0, 1);
  for (int first = 0; first < patch.stride; first += 8) {
    const ColumnSums sums = column_sums(patch, first);
    for (std::size_t i = 0; i < 8; i += 4) {
      const cv::v_int32x4 four_s = cv::v_load(sums.s.data() + i);
      const cv::v_int32x4 four_y = cv::v_load(sums.y.data() + i);
      const cv::v_int32x4 four_yy = cv::v_load(sums.yy.data() + i);
      const auto add = [&](cv::v_float64x2 of_s, cv::v_float64x2 of_y, cv::v_float64x2 of_yy) {
        s += of_s;
        x += column * of_s;
        xx += column * (column * of_s);
        y += of_y;
        xy += column * of_y;
        yy += of_yy;
        column += two;
      };
      add(cv::v_cvt_f64(four_s), cv::v_cvt_f64(four_y), cv::v_cvt_f64(four_yy));
      add(cv::v_cvt_f64_high(four_s), cv::v_cvt_f64_high(four_y), cv::v_cvt_f64_high(four_yy));
    }
  }
  const auto sum = [](cv::v_float64x2 parts) { return cv::v_reduce_sum(parts); };
  return {sum(s), sum(x), sum(y), sum(xx), sum(xy), sum(yy)};
}

struct Ellipse {
  cv::Point2d centre;
  double xx, xy, yy;  // covariance, px^2
  double area_px;     // the sum of all weights
};

std::optional<Ellipse> ellipse_of(const MarkPatch& patch) {
  const Sums sums = sums_of(patch);
  if (sums.s < patch.contrast) return std::nullopt;
  Ellipse out{};
  out.centre = {sums.x / sums.s, sums.y / sums.s};
  out.xx = sums.xx / sums.s - out.centre.x * out.centre.x;
  out.xy = sums.xy / sums.s - out.centre.x * out.centre.y;
  out.yy = sums.yy / sums.s - out.centre.y * out.centre.y;
  out.area_px = sums.s / patch.contrast;
  if (out.xx <= 0 || out.yy <= 0 || out.xx * out.yy <= out.xy * out.xy) return std::nullopt;
  return out;
}

WeightedShape shape_of(const MarkPatch& patch, const Ellipse& ellipse) {
  return {.weights = patch.values.data(),
          .stride = patch.stride,
          .size = patch.size,
          .centre = ellipse.centre,
          .spread = root_of({ellipse.xx, ellipse.xy, ellipse.xy, ellipse.yy}),
          .full = static_cast<double>(patch.contrast)};
}

// M. K. Hu, Visual Pattern Recognition by Moment Invariants, 1962.
std::array<double, 3> hu_moments(const MarkPatch& patch, const Ellipse& e) {
  double mu30 = 0;
  double mu21 = 0;
  double mu12 = 0;
  double mu03 = 0;
  for (int y = 0; y < patch.size.height; ++y) {
    for (int x = 0; x < patch.size.width; ++x) {
      const double w = patch.row(y)[x] / static_cast<double>(patch.contrast);
      const double u = x - e.centre.x;
      const double v = y - e.centre.y;
      mu30 += w * u * u * u;
      mu21 += w * u * u * v;
      mu12 += w * u * v * v;
      mu03 += w * v * v * v;
    }
  }
  const double third = e.area_px * e.area_px * std::sqrt(e.area_px);
  const double n20 = e.xx / e.area_px;
  const double n02 = e.yy / e.area_px;
  const double n11 = e.xy / e.area_px;
  const double h1 = n20 + n02;
  const double h2 = (n20 - n02) * (n20 - n02) + 4 * n11 * n11;
  const double a = (mu30 - 3 * mu12) / third;
  const double b = (3 * mu21 - mu03) / third;
  return {2 * CV_PI * h1, 1e6 * h2, 1e9 * (a * a + b * b)};
}

}  // namespace

std::optional<SeenMark> measure_mark(const ImageCut& cut, MarkContour contour, MarkTone tone) {
  MarkPatch patch;
  if (!patch.cut(cut, contour, tone)) return std::nullopt;
  const std::optional<Ellipse> ellipse = ellipse_of(patch);
  if (!ellipse) return std::nullopt;
  std::optional<SeenMark> out(std::in_place);
  out->tone = tone;
  out->centre = patch.in_image(ellipse->centre);
  out->box = patch.mark_box;
  out->area_px = patch.area_px;
  out->perimeter_px = static_cast<int>(contour.size());
  out->width_px = patch.reduction * std::sqrt(ellipse->xx);
  out->height_px = patch.reduction * std::sqrt(ellipse->yy);
  out->slant_px2 = patch.reduction * patch.reduction * ellipse->xy;
  const double mean = (ellipse->xx + ellipse->yy) / 2;
  const double difference = (ellipse->xx - ellipse->yy) / 2;
  const double half = std::sqrt(difference * difference + ellipse->xy * ellipse->xy);
  out->slimness = std::sqrt(std::max(0.0, mean - half) / (mean + half));
  out->roundness = 4 * CV_PI * std::sqrt(ellipse->xx * ellipse->yy - ellipse->xy * ellipse->xy) / ellipse->area_px;
  out->mark_level = patch.mark_level;
  out->ground_level = patch.ground_level;
  out->noise = cut.noise;
  out->signature = signature_of(shape_of(patch, *ellipse));
  out->contour = std::move(contour);
  return out;
}

// Of more, a black that is a few grey levels says nothing.
double print_contrast(const SeenMark& mark) {
  const double most = std::log(20);
  return std::min(most, std::abs(std::log((mark.ground_level + 1) / (mark.mark_level + 1))));
}

double centre_noise_px(const SeenMark& mark, double noise) {
  constexpr double least_noise = 0.3;  // that of rounding to grey levels
  constexpr double edge_px = 8;        // across, by which noise moves an edge, smoothed and blurred: measured
  constexpr double corners_px = 1.5;  // how far noise as large as the contrast would move the middle of a tag's corners
  const double contrast = std::max(1.0, std::abs(mark.mark_level - mark.ground_level));
  if (mark.tag) return corners_px * std::max(noise, least_noise) / contrast;
  // Those counted are the mark's pixels and the two around it. A disc's edge, and a square's, reaches sqrt(2) times as
  // far as its area.
  const bool by_edge = is_large_mark(mark.box);
  const double counted = by_edge ? edge_px * mark.perimeter_px : mark.area_px + 2 * mark.perimeter_px;
  const double reach2 = mark.width_px * mark.width_px * (by_edge ? 2 : counted / mark.area_px);
  return std::max(noise, least_noise) * std::sqrt(counted * reach2) / (contrast * mark.area_px);
}

double centre_spread_px(const SeenMark& mark, double noise) {
  constexpr double systematic_px = 0.02;
  return std::hypot(centre_noise_px(mark, noise), systematic_px);
}

void move_by(SeenMark& mark, cv::Point origin) {
  mark.centre += cv::Point2d(origin);
  mark.box += origin;
  for (cv::Point& p : mark.contour) p += origin;
}

std::optional<MarkPortrait> portray_mark(const ImageCut& cut, const MarkContour& contour, MarkTone tone) {
  MarkPatch patch;
  if (!patch.cut(cut, contour, tone)) return std::nullopt;
  const std::optional<Ellipse> ellipse = ellipse_of(patch);
  if (!ellipse) return std::nullopt;
  return MarkPortrait{.corners = count_corners(contour),
                      .moments = hu_moments(patch, *ellipse),
                      .picture = template_picture(shape_of(patch, *ellipse))};
}

int count_corners(const MarkContour& contour) {
  const int size = static_cast<int>(contour.size());
  const int reach = std::clamp(size / 16, 2, 6);
  if (size < 4 * reach) return 0;
  const auto at = [&](int i) { return contour[static_cast<std::size_t>((i + size) % size)]; };
  std::vector<double> turn(contour.size());
  for (int i = 0; i < size; ++i) {
    const cv::Point before = at(i) - at(i - reach);
    const cv::Point after = at(i + reach) - at(i);
    turn[static_cast<std::size_t>(i)] = std::abs(std::atan2(before.cross(after), before.dot(after)));
  }
  int corners = 0;
  for (int i = 0; i < size; ++i) {
    const double here = turn[static_cast<std::size_t>(i)];
    bool peak = here > 50 * CV_PI / 180;
    for (int step = 1; step <= reach && peak; ++step) {
      peak = here > turn[static_cast<std::size_t>((i - step + size) % size)] &&
             here >= turn[static_cast<std::size_t>((i + step) % size)];
    }
    corners += peak ? 1 : 0;
  }
  return corners;
}

}  // namespace pizarra::vision
