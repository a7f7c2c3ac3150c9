#pragma once

// Closed contours, followed pixel by pixel in anything that can say of a pixel whether it is inside: a mask, the bits
// of a segmented image, or an image and a threshold.
//
//   std::optional<MarkContour> contour = follow_contour(MaskField(mask), start, 400);
//   std::optional<MarkContour> tracked = contour_from_centre(ToneField(grey, 90, true), last_centre, 12, 400);

#include <array>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace pizarra {

using MarkContour = std::vector<cv::Point>;  // the region's border pixels, px, 8-connected, in order

// What a contour is followed in has cols() and rows(), and says inside(index) of the pixel (x, y) whose index is
// y * stride() + x, as a BitImage does.
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
        inverted_(dark ? 0 : 255),
        threshold_(dark ? threshold : 255 - threshold) {}
  int cols() const { return size_.width; }
  int rows() const { return size_.height; }
  std::ptrdiff_t stride() const { return stride_; }
  bool inside(std::ptrdiff_t index) const { return (pixels_[index] ^ inverted_) < threshold_; }

 private:
  const std::uint8_t* pixels_;
  std::ptrdiff_t stride_;
  cv::Size size_;
  int inverted_;  // each bit of a level, where what is lighter is inside
  int threshold_;
};

// The eight neighbours in clockwise order (y down), from the left.
inline constexpr std::array<std::array<int, 2>, 8> neighbours = {
    {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}}};

// Twice the enclosed area, positive when the contour runs clockwise in the image.
long signed_area(const MarkContour& contour);

// Follows the outer border of the region that `start` belongs to; the pixel left of `start` is outside. Nothing when it
// is longer than `max_points`, or runs along the field's edge (it is open there).
template <typename Field>
std::optional<MarkContour> follow_contour(const Field& field, cv::Point start, std::size_t max_points) {
  constexpr std::size_t count = neighbours.size();
  std::array<std::ptrdiff_t, 2 * count> offsets;  // to the neighbours, twice round
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    offsets[i] = neighbours[i % count][1] * field.stride() + neighbours[i % count][0];
  }
  MarkContour contour;
  contour.reserve(128);
  cv::Point at = start;
  std::ptrdiff_t index = start.y * field.stride() + start.x;
  std::size_t outside_direction = 0;  // where, seen from `at`, the last outside pixel lies
  std::size_t first_step = count;
  while (true) {
    if (at.x <= 0 || at.y <= 0 || at.x >= field.cols() - 1 || at.y >= field.rows() - 1) return std::nullopt;
    if (contour.size() >= max_points) return std::nullopt;
    std::size_t turn = 1;
    while (turn < count && !field.inside(index + offsets[outside_direction + turn])) ++turn;
    if (turn == count) return MarkContour{at};
    const std::size_t step = (outside_direction + turn) % count;
    if (at == start && step == first_step) return contour;
    if (contour.empty()) first_step = step;
    contour.push_back(at);
    at += cv::Point(neighbours[step][0], neighbours[step][1]);
    index += offsets[step];
    // The neighbour looked at before the step was outside; from the new place it lies one or two turns further back.
    outside_direction = (step + (step % 2 == 0 ? 6 : 5)) % count;
  }
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

}  // namespace pizarra
