#include "agents/vision/marks/tag_mark.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_fit.hpp"
#include "agents/vision/marks/tag_light.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

// Half a cell beside a tag's border, as a part of its side; and by how much, in how many places, it is lighter outside.
constexpr double beside_border = 0.05;
constexpr int border_places = 8;  // a side
constexpr double least_contrast = 20;
constexpr double least_tag_border_share = 0.75;

// How far off the middle of a tag may be, by what covers a part of its border, that is found: px, or a part of its
// side.
constexpr double most_tag_off_px = 1;
constexpr double most_tag_off_share = 0.015;
// By so much, as a part of it, what the cells say of that may be too little (tag_fit.hpp).
constexpr double fit_slack = 0.15;

cv::Point2d diagonals_meet(const TagCorners& c) {
  const cv::Point2d a = c[2] - c[0];
  const cv::Point2d b = c[3] - c[1];
  const cv::Point2d between = c[1] - c[0];
  const double across = a.cross(b);
  return cv::Point2d(c[0]) + a * (std::abs(across) < 1e-9 ? 0.5 : between.cross(b) / across);
}

MarkContour outline_of(const cv::Mat& grey, const TagCorners& corners) {
  MarkContour out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::Point from(corners[i]);
    const cv::Point to(corners[(i + 1) % corners.size()]);
    cv::LineIterator line(grey, from, to);
    // The last pixel is the next side's first.
    for (int j = 0; j + 1 < line.count; ++j, ++line) out.push_back(line.pos());
  }
  return out;
}

// Along each side, half a cell within the border and as far outside; not beyond the image.
template <class Visit>
void visit_border(const cv::Mat1b& grey, const TagCorners& corners, const Visit& visit) {
  const cv::Point2d middle = diagonals_meet(corners);
  const cv::Rect image({0, 0}, grey.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::Point2d from(corners[i]);
    const cv::Point2d along = cv::Point2d(corners[(i + 1) % corners.size()]) - from;
    for (int j = 0; j < border_places; ++j) {
      const cv::Point2d on = from + along * ((j + 0.5) / border_places);
      const cv::Point2d outwards = (on - middle) * (2 * beside_border);
      const cv::Point outside(on + outwards);
      const cv::Point inside(on - outwards);
      if (image.contains(outside) && image.contains(inside)) visit(grey(inside), grey(outside));
    }
  }
}

struct BorderLevels {
  double inside = 0;
  double outside = 0;
};

BorderLevels levels_along_border(const cv::Mat1b& grey, const TagCorners& corners) {
  BorderLevels sum;
  int places = 0;
  visit_border(grey, corners, [&](int inside, int outside) {
    sum.inside += inside;
    sum.outside += outside;
    ++places;
  });
  const double each = 1.0 / std::max(1, places);
  return {sum.inside * each, sum.outside * each};
}

SeenMark mark_of(const cv::Mat& grey, const TagCorners& corners, Tag tag) {
  const cv::Moments moments = cv::moments(corners);
  const double xx = moments.mu20 / moments.m00;
  const double yy = moments.mu02 / moments.m00;
  const double xy = moments.mu11 / moments.m00;
  const double spread = std::hypot((xx - yy) / 2, xy);
  SeenMark out;
  out.tag = std::move(tag);
  std::ranges::copy(corners, out.corners.begin());
  const BorderLevels levels = levels_along_border(grey, corners);
  out.mark_level = levels.inside;
  out.ground_level = levels.outside;
  out.centre = diagonals_meet(corners);
  out.contour = outline_of(grey, corners);
  out.box = cv::boundingRect(out.contour);
  out.area_px = moments.m00;
  out.perimeter_px = static_cast<int>(out.contour.size());
  out.width_px = std::sqrt(xx);
  out.height_px = std::sqrt(yy);
  out.slimness = std::sqrt(((xx + yy) / 2 - spread) / ((xx + yy) / 2 + spread));
  out.roundness = 2 * CV_PI * (xx + yy) / moments.m00;
  return out;
}

}  // namespace

double least_tag_likeness(const TagFamily& family) {
  constexpr int cells_to_be_sure = 4;
  const bool is_sure = !family.is_wide() && dictionary_of(family)->maxCorrectionBits >= cells_to_be_sure;
  return is_sure ? 0.6 : 0.74;
}

double side_px(const TagCorners& corners) { return cv::arcLength(corners, true) / 4; }

bool has_a_border(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family) {
  const int sign = family.is_wide() ? -1 : 1;
  int agreeing = 0;
  visit_border(grey, corners,
               [&](int inside, int outside) { agreeing += sign * (outside - inside) > least_contrast ? 1 : 0; });
  return agreeing >= least_tag_border_share * border_places * static_cast<double>(corners.size());
}

std::optional<SeenMark> whole_tag(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family,
                                  int number) {
  const double allowed = std::max(most_tag_off_px, most_tag_off_share * side_px(corners));
  const double doubt = (1 + fit_slack) * middle_off_px(grey, corners, family, number) / allowed;
  if (doubt > 1) return std::nullopt;
  SeenMark out = mark_of(grey, corners, {std::string(family.name), number});
  out.tag_doubt = doubt;
  return out;
}

double tag_likeness(const cv::Mat1b& grey, const TagCorners& corners, const TagFamily& family, int number) {
  constexpr int cell_px = 4;
  const cv::Mat1b cells = print_of(family, number);
  cv::Mat1b print;
  cv::resize(cells, print, {}, cell_px, cell_px, cv::INTER_NEAREST);
  const cv::Mat1b seen = squared(grey, corners, print.cols, family.cells_around * cell_px);
  cv::Mat1b printed = print != unprinted;
  if (cv::countNonZero(printed) == static_cast<int>(printed.total())) printed.release();
  const auto likeness = [&](const cv::Mat1b& picture) {
    cv::Mat1f like;
    cv::matchTemplate(picture, print, like, cv::TM_CCOEFF_NORMED, printed);
    return static_cast<double>(like(0, 0));
  };
  return std::max(likeness(seen), likeness(evenly_lit(seen, cells)));
}

}  // namespace pizarra::vision
