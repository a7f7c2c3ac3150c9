#include "agents/vision/marks/tag_fit.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/vision/marks/robust.hpp"
#include "agents/vision/marks/tag_light.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

constexpr int cell_px = 6;
// So that edges that are some of a cell off are told by their slopes.
constexpr double blur_px = 0.3 * cell_px;
// Of the outermost cells this much is not looked at: what is beyond it is none of the tag's.
constexpr int margin_px = cell_px / 2;
// How much the corners are held where they are, where few edges tell: a part of what edges weigh.
constexpr double hold = 2e-5;

// Two levels, and how far each corner is off along x and along y.
constexpr int unknowns = 10;
using Unknowns = cv::Vec<double, unknowns>;
using Square = std::array<cv::Point2f, 4>;

cv::Mat1f blurred(const cv::Mat& image) {
  cv::Mat1f out;
  image.convertTo(out, CV_32F, 1.0 / 255);
  cv::GaussianBlur(out, out, {}, blur_px, blur_px, cv::BORDER_REPLICATE);
  return out;
}

// A tag as it is printed, and its slopes.
struct Print {
  Print(const cv::Mat1b& cells, int cells_around) : side(cells.cols * cell_px), around(cells_around * cell_px) {
    cv::Mat drawn;
    cv::resize(cells, drawn, {side, side}, 0, 0, cv::INTER_NEAREST);
    light = blurred(drawn);
    cv::Sobel(light, along_x, CV_32F, 1, 0, 3, 1.0 / 8);
    cv::Sobel(light, along_y, CV_32F, 0, 1, 3, 1.0 / 8);
    if (around > 0) leave_out(cells == unprinted);
  }
  bool tells(int x, int y) const { return left_out.empty() || left_out(y, x) == 0; }
  Square corners() const {
    const float begin = static_cast<float>(around) - 0.5F;
    const float end = static_cast<float>(side - around) - 0.5F;
    return {cv::Point2f(begin, begin), {end, begin}, {end, end}, {begin, end}};
  }
  // What each unknown adds to the level there; a corner the more the nearer it is.
  Unknowns row(int x, int y) const {
    const double u = (x + 0.5 - around) / (side - 2 * around);
    const double v = (y + 0.5 - around) / (side - 2 * around);
    const std::array<double, 4> near = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    Unknowns out;
    out[0] = 1;
    out[1] = light(y, x);
    for (int i = 0; i < 4; ++i) {
      out[2 + 2 * i] = along_x(y, x) * near[static_cast<std::size_t>(i)];
      out[3 + 2 * i] = along_y(y, x) * near[static_cast<std::size_t>(i)];
    }
    return out;
  }

  // What is not printed, and the square's edge: the corners were put on it, and it may be that of a cover.
  void leave_out(const cv::Mat1b& unprinted_cells) {
    cv::resize(unprinted_cells, left_out, {side, side}, 0, 0, cv::INTER_NEAREST);
    cv::rectangle(left_out, {around, around, side - 2 * around, side - 2 * around}, 255);
    cv::dilate(left_out, left_out, cv::Mat1b::ones(2 * margin_px + 1, 2 * margin_px + 1));
  }

  int side;
  int around;  // beyond the square whose corners are sought
  cv::Mat1b left_out;
  cv::Mat1f light;
  cv::Mat1f along_x;
  cv::Mat1f along_y;
};

// How far the image is from the print that these explain, place by place; nothing where the print says nothing.
template <class Visit>
void visit_left_over(const Print& print, const cv::Mat1f& seen, const Unknowns& found, const Visit& visit) {
  for (int y = margin_px; y < print.side - margin_px; ++y) {
    for (int x = margin_px; x < print.side - margin_px; ++x) {
      if (!print.tells(x, y)) continue;
      const Unknowns row = print.row(x, y);
      visit(row, seen(y, x), seen(y, x) - row.dot(found));
    }
  }
}

// By linear least squares, each place weighed by how far it is from what was found before.
Unknowns solved(const Print& print, const cv::Mat1f& seen, const Unknowns& before, double spread) {
  cv::Matx<double, unknowns, unknowns> normal = cv::Matx<double, unknowns, unknowns>::zeros();
  Unknowns right = Unknowns::all(0);
  visit_left_over(print, seen, before, [&](const Unknowns& row, double level, double off) {
    const double weight = tukey_weight(off, spread);
    for (int i = 0; i < unknowns; ++i) {
      for (int j = 0; j < unknowns; ++j) normal(i, j) += weight * row[i] * row[j];
    }
    right += row * (weight * level);
  });
  for (int i = 2; i < unknowns; ++i) normal(i, i) += hold * print.side * print.side;
  return normal.solve(right, cv::DECOMP_CHOLESKY);
}

double typical_left_over(const Print& print, const cv::Mat1f& seen, const Unknowns& found) {
  std::vector<double> out;
  visit_left_over(print, seen, found, [&](const Unknowns&, double, double off) { out.push_back(std::abs(off)); });
  return median(std::move(out));
}

// Every place weighs the same.
Unknowns solved_at_once(const Print& print, const cv::Mat1f& seen) {
  return solved(print, seen, Unknowns::all(0), std::numeric_limits<double>::infinity());
}

// A place shows the print a little beside it, as far as the corners are off (B. Lucas, T. Kanade, An iterative image
// registration technique, IJCAI 1981). A shadow's edge or a cover counts less with each step.
Unknowns fit(const Print& print, const cv::Mat1f& seen) {
  constexpr int steps = 2;
  constexpr double least_left_over = 1.0 / 255;
  Unknowns out = solved_at_once(print, seen);
  for (int i = 0; i < steps; ++i) {
    const double spread = deviations_of_median * typical_left_over(print, seen, out);
    out = solved(print, seen, out, std::max(least_left_over, spread));
  }
  return out;
}

// How far the image is from the print, as a part of the print's contrast.
double left_over(const Print& print, const cv::Mat1f& seen, const Unknowns& found) {
  return typical_left_over(print, seen, found) / std::abs(found[1]);
}

cv::Point2d mapped(const cv::Matx33d& by, cv::Point2d p) {
  const cv::Vec3d to = by * cv::Vec3d(p.x, p.y, 1);
  return {to[0] / to[2], to[1] / to[2]};
}

// A tag's print and its picture, made square by the corners.
struct Placed {
  Placed(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number)
      : cells(print_of(family, number)),
        print(cells, family.cells_around),
        to_image(cv::getPerspectiveTransform(print.corners().data(), corners.data())),
        picture(squared(grey, corners, print.side, print.around)) {}

  cv::Mat1b cells;
  Print print;
  cv::Matx33d to_image;
  cv::Mat1b picture;
};

// As it is or with the light divided out, whichever the print explains better.
Unknowns fitted(const Placed& tag) {
  const cv::Mat1f as_it_is = blurred(tag.picture);
  const cv::Mat1f even = blurred(evenly_lit(tag.picture, tag.cells));
  const Unknowns found = fit(tag.print, as_it_is);
  const Unknowns found_even = fit(tag.print, even);
  return left_over(tag.print, as_it_is, found) <= left_over(tag.print, even, found_even) ? found : found_even;
}

// How far a corner is off, in the print.
cv::Point2d corner_off(const Unknowns& found, int corner) {
  return cv::Point2d(found[2 + 2 * corner], found[3 + 2 * corner]) / found[1];
}

double middle_off_px(const Placed& tag, const Unknowns& found) {
  cv::Point2d moved;
  for (int i = 0; i < 4; ++i) moved += corner_off(found, i) / 4;
  const cv::Point2d middle(tag.print.side / 2.0 - 0.5, tag.print.side / 2.0 - 0.5);
  return cv::norm(mapped(tag.to_image, middle) - mapped(tag.to_image, middle - moved));
}

}  // namespace

double middle_off_px(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number) {
  const Placed tag(grey, corners, family, number);
  const double at_once = middle_off_px(tag, solved_at_once(tag.print, blurred(tag.picture)));
  return at_once < hardly_off_px ? at_once : middle_off_px(tag, fitted(tag));
}

TagCorners fitted_corners(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number) {
  const Placed tag(grey, corners, family, number);
  const Unknowns found = fitted(tag);
  TagCorners out;
  for (int i = 0; i < 4; ++i) {
    const cv::Point2d corner(tag.print.corners()[static_cast<std::size_t>(i)]);
    out.emplace_back(mapped(tag.to_image, corner - corner_off(found, i)));
  }
  return out;
}

}  // namespace pizarra::vision
