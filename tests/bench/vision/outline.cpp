#include "tests/bench/vision/outline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pizarra::bench {
namespace {

// How much of each pixel lies right of the edges entered so far; a running sum along each row then covers the inside.
// (The accumulation buffer of font rasterisers.)
class Coverage {
 public:
  Coverage(int width, int height) : width_(width), height_(height), cells_(height, width + 2, 0.F) {}

  // In px from the buffer's corner. The buffer holds the whole outline.
  void enter(cv::Point2d from, cv::Point2d to) {
    if (from.y == to.y) return;
    const double sign = from.y < to.y ? 1 : -1;
    if (from.y > to.y) std::swap(from, to);
    const double slope = (to.x - from.x) / (to.y - from.y);
    for (int y = static_cast<int>(from.y); y < height_ && y < to.y; ++y) {
      const double top = std::max<double>(y, from.y);
      const double bottom = std::min<double>(y + 1, to.y);
      if (bottom <= top) continue;
      enter_row(cells_[y], from.x + slope * (top - from.y), from.x + slope * (bottom - from.y), sign * (bottom - top));
    }
  }

  void finish_row(int y, float* covered) const {
    float sum = 0;
    for (int x = 0; x < width_; ++x) {
      sum += cells_(y, x);
      covered[x] = std::min(1.F, std::abs(sum));
    }
  }

 private:
  // An edge within one row, `height` high: each pixel it passes gets its own share of the height, and what of that
  // share lies left of the edge's middle there goes to the next pixel.
  void enter_row(float* row, double a, double b, double height) const {
    const double left = std::min(a, b);
    const double right = std::max(a, b);
    const int first = std::clamp(static_cast<int>(left), 0, width_ - 1);
    const int last = std::clamp(static_cast<int>(right), 0, width_ - 1);
    for (int x = first; x <= last; ++x) {
      const double from = std::max<double>(left, x);
      const double to = std::min<double>(right, x + 1);
      const double share = right > left ? height * (to - from) / (right - left) : height;
      const double left_of_edge = (from + to) / 2 - x;
      row[x] += static_cast<float>(share * (1 - left_of_edge));
      row[x + 1] += static_cast<float>(share * left_of_edge);
    }
  }

  int width_;
  int height_;
  cv::Mat1f cells_;
};

cv::Rect bounds_of(const Shape& shape) {
  cv::Point2d low(1e9, 1e9);
  cv::Point2d high(-1e9, -1e9);
  for (const Outline& outline : shape) {
    for (const cv::Point2d& p : outline) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const cv::Point first(cvFloor(low.x + 0.5), cvFloor(low.y + 0.5));
  return {first, cv::Point(cvFloor(high.x + 0.5) + 2, cvFloor(high.y + 0.5) + 2)};
}

Outline cross_outline(double a, double b) {
  return {{-b, -a}, {b, -a}, {b, -b}, {a, -b}, {a, b}, {b, b}, {b, a}, {-b, a}, {-b, b}, {-a, b}, {-a, -b}, {-b, -b}};
}

}  // namespace

Shape disc(double radius) {
  Outline out;
  constexpr int sides = 96;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * CV_PI * i / sides;
    out.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return {out};
}

Shape box(double width, double height) {
  const double x = width / 2;
  const double y = height / 2;
  return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
}

Shape mark_shape(const std::string& name) {
  if (name == "circle") return disc(22);
  if (name == "square") return box(44, 44);
  if (name == "cross") return {cross_outline(22, 44 / 6.0)};
  if (name == "plate") return {{{-29, -34}, {29, -34}, {29, 22}, {-29, 22}}};
  assert(name == "triangle");
  return {{{0, -37 * 2 / 3.0}, {22, 37 / 3.0}, {-22, 37 / 3.0}}};
}

Shape tag_shape(const cv::Mat1b& dark_cells, double size) {
  Shape out;
  const double cell = size / dark_cells.cols;
  for (int y = 0; y < dark_cells.rows; ++y) {
    for (int x = 0; x < dark_cells.cols; ++x) {
      if (dark_cells(y, x) == 0) continue;
      const cv::Point2d corner(x * cell - size / 2, y * cell - size / 2);
      Outline square = box(cell, cell).front();
      for (cv::Point2d& p : square) p += corner + cv::Point2d(cell / 2, cell / 2);
      out.push_back(square);
    }
  }
  return out;
}

Shape placed(const Shape& shape, cv::Point2d centre, double scale, double turn_deg) {
  const double c = scale * std::cos(turn_deg * CV_PI / 180);
  const double s = scale * std::sin(turn_deg * CV_PI / 180);
  Shape out(shape);
  for (Outline& outline : out) {
    for (cv::Point2d& p : outline) p = centre + cv::Point2d(c * p.x - s * p.y, s * p.x + c * p.y);
  }
  return out;
}

void paint(cv::Mat1f& image, const Shape& shape, float value) {
  const cv::Rect bounds = bounds_of(shape);
  const cv::Rect visible = bounds & cv::Rect(0, 0, image.cols, image.rows);
  if (visible.empty()) return;
  Coverage coverage(bounds.width, bounds.height);
  const cv::Point2d shift = cv::Point2d(0.5, 0.5) - cv::Point2d(bounds.tl());
  for (const Outline& outline : shape) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      coverage.enter(outline[i] + shift, outline[(i + 1) % outline.size()] + shift);
    }
  }
  std::vector<float> covered(static_cast<std::size_t>(bounds.width));
  for (int y = visible.y; y < visible.br().y; ++y) {
    coverage.finish_row(y - bounds.y, covered.data());
    for (int x = visible.x; x < visible.br().x; ++x) {
      const float share = covered[static_cast<std::size_t>(x - bounds.x)];
      image(y, x) += share * (value - image(y, x));
    }
  }
}

}  // namespace pizarra::bench
