#pragma once

// Closed contours, followed pixel by pixel in anything that can say of a pixel whether it is inside: a mask, the bits
// of a segmented image, or an image and a threshold.
//
//   std::optional<MarkContour> contour = follow_contour(MaskField(mask), start, 400);
//   std::optional<MarkContour> tracked = contour_from_centre(ToneField(grey, 90, true), last_centre, 12, 400);

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace pizarra::vision {

using MarkContour = std::vector<cv::Point>;  // the region's border pixels, px, 8-connected, in order

// The field that a contour is followed in. Like a BitImage it has cols() and rows(), and inside(index) of the pixel (x,
// y), the index being y * stride() + x.
class MaskField {
 public:
  explicit MaskField(const cv::Mat1b& mask) : pixels_(mask.data), stride_(mask.step), size_(mask.size()) {}
  int cols() const { return size_.width; }
  int rows() const { return size_.height; }
  std::ptrdiff_t stride() const { return stride_; }
  bool inside(std::ptrdiff_t index) const { return pixels_[index] != 0; }

 private:
  const std::uint8_t* pixels_;
  std::ptrdiff_t stride_;
  cv::Size size_;
};

// Inside is what is darker, or lighter, than the threshold.
class ToneField {
 public:
  ToneField(const cv::Mat1b& grey, int threshold, bool dark)
      : pixels_(grey.data),
        stride_(grey.step),
        size_(grey.size()),
        inverted_(static_cast<std::int16_t>(dark ? 0 : 255)),
        threshold_(static_cast<std::int16_t>(dark ? threshold : 255 - threshold)) {}
  int cols() const { return size_.width; }
  int rows() const { return size_.height; }
  std::ptrdiff_t stride() const { return stride_; }
  bool inside(std::ptrdiff_t index) const { return (pixels_[index] ^ inverted_) < threshold_; }

 private:
  const std::uint8_t* pixels_;
  std::ptrdiff_t stride_;
  cv::Size size_;
  // No integers, which would be read anew after every point of a contour that is stored.
  std::int16_t inverted_;  // each bit of a level, where what is lighter is inside
  std::int16_t threshold_;
};

// The eight neighbours in clockwise order (y down), from the left.
inline constexpr std::array<std::array<int, 2>, 8> neighbours = {
    {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}}};

// Twice the enclosed area, positive when the contour runs clockwise in the image.
long signed_area(const MarkContour& contour);
// Of one that has points.
cv::Rect box_of(const MarkContour& contour);

// Follows the outer border of the region that `start` belongs to; the pixel left of `start` is outside. Nothing when it
// is longer than `max_points`, or runs along the field's edge (it is open there).
template <typename Field>
std::optional<MarkContour> follow_contour(const Field& field, cv::Point start, std::size_t max_points) {
  constexpr std::size_t count = neighbours.size();
  std::array<std::ptrdiff_t, 2 * count> offsets;  // to the neighbours, twice round
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    offsets[i] = neighbours[i % count][1] * field.stride() + neighbours[i % count][0];
  }
  // Negative numbers are large ones without a sign.
  const auto width = static_cast<unsigned>(std::max(0, field.cols() - 2));
  const auto height = static_cast<unsigned>(std::max(0, field.rows() - 2));
  const auto is_within = [&](int x, int y) {
    return static_cast<unsigned>(x - 1) < width && static_cast<unsigned>(y - 1) < height;
  };
  if (!is_within(start.x, start.y)) return std::nullopt;
  const std::ptrdiff_t start_index = start.y * field.stride() + start.x;
  std::size_t first_step = 1;
  while (first_step < count && !field.inside(start_index + offsets[first_step])) ++first_step;
  if (first_step == count) return MarkContour{start};
  MarkContour contour;
  contour.reserve(128);
  int x = start.x;
  int y = start.y;
  std::ptrdiff_t index = start_index;
  std::size_t step = first_step;
  for (std::size_t left = max_points; left > 0; --left) {
    contour.emplace_back(x, y);
    x += neighbours[step][0];
    y += neighbours[step][1];
    if (!is_within(x, y)) return std::nullopt;
    index += offsets[step];
    // The neighbour looked at before the step was outside; from the new place it lies one or two turns further back.
    // The place before is inside, so some neighbour is.
    std::size_t turned = (step + (step % 2 == 0 ? 6 : 5)) % count + 1;
    while (!field.inside(index + offsets[turned])) ++turned;
    step = turned % count;
    if (index == start_index && step == first_step) return contour;
  }
  return std::nullopt;
}

// The interline method: looks for an inside pixel within `reach_px` of `centre`, goes left along its line to the border
// and follows that. Nothing when there is none, or the border found is that of a hole.
template <typename Field>
std::optional<MarkContour> contour_from_centre(const Field& field, cv::Point centre, int reach_px,
                                               std::size_t max_points) {
  const cv::Rect area(0, 0, field.cols(), field.rows());
  for (int radius = 0; radius <= reach_px; ++radius) {
    for (int dy = -radius; dy <= radius; ++dy) {
      const int stride = std::abs(dy) == radius ? 1 : 2 * radius;
      for (int dx = -radius; dx <= radius; dx += stride) {
        cv::Point p = centre + cv::Point(dx, dy);
        const auto inside = [&](int x) { return field.inside(p.y * field.stride() + x); };
        if (!area.contains(p) || !inside(p.x)) continue;
        while (p.x > 0 && inside(p.x - 1)) --p.x;
        std::optional<MarkContour> contour = follow_contour(field, p, max_points);
        if (contour && contour->size() > 1 && signed_area(*contour) <= 0) return std::nullopt;
        return contour;
      }
    }
  }
  return std::nullopt;
}

}  // namespace pizarra::vision
