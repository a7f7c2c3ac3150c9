#include "agents/vision/marks/tags.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/marks/tag_fit.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

constexpr double most_row_difference_px = 2;
// With less in common with its print a square is none: of a tag whose cells are two pixels wide another family may read
// a tag of its own, 0.5 to 0.74 like that; a blurred one that can be found is 0.74 to 0.8 like its print.
constexpr double least_likeness = 0.74;
// Around a tag there must be light for its border to be seen.
constexpr double margin_of_side = 0.35;
// Half a cell beside a tag's border, as a part of its side; and by how much, in how many places, it is lighter outside.
constexpr double beside_border = 0.05;
constexpr int border_places = 8;  // a side
constexpr double least_contrast = 20;
constexpr double least_border_share = 0.75;

// How far off the middle of a tag may be, by what covers a part of its border, that is found: px, or a part of its
// side.
constexpr double most_off_px = 1;
constexpr double most_off_share = 0.015;
// By so much, as a part of it, what the cells say of that may be too little (tag_fit.hpp).
constexpr double fit_slack = 0.15;

using Corners = TagCorners;

void move_by(Corners& corners, cv::Point origin) {
  for (cv::Point2f& p : corners) p += cv::Point2f(origin);
}

double side_px(const Corners& corners) { return cv::arcLength(corners, true) / 4; }

cv::Rect around(const Corners& corners, cv::Size image) {
  const int margin = cvCeil(margin_of_side * side_px(corners)) + 2;
  const cv::Rect box = cv::boundingRect(corners);
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
         cv::Rect({0, 0}, image);
}

cv::Point2d diagonals_meet(const Corners& c) {
  const cv::Point2d a = c[2] - c[0];
  const cv::Point2d b = c[3] - c[1];
  const cv::Point2d between = c[1] - c[0];
  const double across = a.cross(b);
  return cv::Point2d(c[0]) + a * (std::abs(across) < 1e-9 ? 0.5 : between.cross(b) / across);
}

MarkContour outline_of(const cv::Mat& grey, const Corners& corners) {
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
void visit_border(const cv::Mat1b& grey, const Corners& corners, const Visit& visit) {
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

BorderLevels levels_along_border(const cv::Mat1b& grey, const Corners& corners) {
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

SeenMark mark_of(const cv::Mat& grey, const Corners& corners, Tag tag) {
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
  out.box = cv::boundingRect(corners);
  out.area_px = moments.m00;
  out.perimeter_px = static_cast<int>(out.contour.size());
  out.width_px = std::sqrt(xx);
  out.height_px = std::sqrt(yy);
  out.slimness = std::sqrt(((xx + yy) / 2 - spread) / ((xx + yy) / 2 + spread));
  out.roundness = 2 * CV_PI * (xx + yy) / moments.m00;
  return out;
}

bool is_around(const Corners& corners, cv::Point2d point) {
  return cv::pointPolygonTest(corners, cv::Point2f(point), false) >= 0;
}

// Whether it is dark within the border and light around it. Cells alone are no proof: of the larger families' codes a
// light triangle may spell one.
bool has_a_border(const cv::Mat1b& grey, const Corners& corners) {
  int agreeing = 0;
  visit_border(grey, corners, [&](int inside, int outside) { agreeing += outside - inside > least_contrast ? 1 : 0; });
  return agreeing >= least_border_share * border_places * static_cast<double>(corners.size());
}

// The tag, unless its corners are not its own but where something lies over its border.
std::optional<SeenMark> whole_mark(const cv::Mat1b& grey, const Corners& corners, const TagFamily& family, int number) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family.dictionary);
  const double allowed = std::max(most_off_px, most_off_share * side_px(corners));
  const double doubt = (1 + fit_slack) * middle_off_px(grey, corners, *dictionary, number) / allowed;
  if (doubt > 1) return std::nullopt;
  SeenMark out = mark_of(grey, corners, {std::string(family.name), number});
  out.tag_doubt = doubt;
  return out;
}

// The largest square around the point, whether a tag of that family or not: light cells may be squares too.
std::optional<Corners> square_around(const TagDetection& detection, cv::Point2d point) {
  std::optional<Corners> best;
  for (const auto* squares : {&detection.found, &detection.others}) {
    for (const Corners& corners : *squares) {
      if (!is_around(corners, point)) continue;
      if (!best || cv::contourArea(corners) > cv::contourArea(*best)) best = corners;
    }
  }
  return best;
}

// In an image as large as a photograph what is large is seen in a smaller image as well, and what is small around a
// point is near it.
std::optional<Corners> square_around(const cv::Mat& grey, cv::Point2d point) {
  constexpr int plenty_px = 1280;
  constexpr int reach_px = 128;  // of the smaller image
  const int parts = (std::max(grey.cols, grey.rows) + plenty_px - 1) / plenty_px;
  if (parts == 1) return square_around(detect_tags(grey, tag_families().front()), point);
  cv::Mat smaller;
  cv::resize(grey, smaller, {}, 1.0 / parts, 1.0 / parts, cv::INTER_AREA);
  std::optional<Corners> large = square_around(detect_tags(smaller, tag_families().front(), 0.2), point / parts);
  if (large) std::ranges::for_each(*large, [&](cv::Point2f& p) { p *= parts; });
  const int reach = reach_px * parts;
  const cv::Rect near =
      cv::Rect(cvRound(point.x) - reach, cvRound(point.y) - reach, 2 * reach, 2 * reach) & cv::Rect({}, grey.size());
  std::optional<Corners> small =
      square_around(detect_tags(grey(near), tag_families().front(), 0.12), point - cv::Point2d(near.tl()));
  if (small) move_by(*small, near.tl());
  return !small || (large && cv::contourArea(*large) > cv::contourArea(*small)) ? large : small;
}

// How like the tag's print that is what the corners enclose, 1 at most.
double likeness(const cv::Mat1b& grey, const Corners& corners, const cv::aruco::Dictionary& dictionary, int number) {
  constexpr int cell_px = 4;
  cv::Mat print;
  dictionary.drawMarker(number, (dictionary.markerSize + 2) * cell_px, print);
  cv::Mat1f like;
  cv::matchTemplate(squared(grey, corners, print.cols), print, like, cv::TM_CCOEFF_NORMED);
  return like(0, 0);
}

struct Reading {
  const TagFamily* family;
  int number;
  Corners corners;
  double likeness;
};

// The tag around the point, of whatever family. Several families may read one tag, some by mending cells: the likest
// reading is taken, the first of equal ones.
std::optional<Reading> read_tag(const cv::Mat& grey, cv::Rect area, cv::Point2d point,
                                std::span<const TagFamily> considered = tag_families()) {
  std::optional<Reading> best;
  for (const TagFamily& family : considered) {
    const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family.dictionary);
    TagDetection detection = detect_tags(grey(area), family);
    for (std::size_t i = 0; i < detection.found.size(); ++i) {
      Corners& corners = detection.found[i];
      move_by(corners, area.tl());
      if (!is_around(corners, point) || !has_a_border(grey, corners)) continue;
      const double like = likeness(grey, corners, *dictionary, detection.numbers[i]);
      if (like <= (best ? best->likeness : least_likeness)) continue;
      best = Reading{&family, detection.numbers[i], std::move(corners), like};
    }
  }
  return best;
}

// Each family is tried in no larger an image than it takes; the one that it is looks at the pixels.
std::optional<Reading> read_large_tag(const cv::Mat& grey, cv::Rect area, cv::Point2d point) {
  constexpr int plenty_px = 640;
  const int parts = (std::max(area.width, area.height) + plenty_px - 1) / plenty_px;
  if (parts == 1) return read_tag(grey, area, point);
  cv::Mat smaller;
  cv::resize(grey(area), smaller, {}, 1.0 / parts, 1.0 / parts, cv::INTER_AREA);
  const cv::Point2d within = point - cv::Point2d(area.tl());
  const std::optional<Reading> what = read_tag(smaller, {{}, smaller.size()}, within / parts);
  return what ? read_tag(grey, area, point, {what->family, 1}) : std::nullopt;
}

}  // namespace

std::string tag_name(const Tag& tag) { return tag.family + "-" + std::to_string(tag.number); }

std::optional<Tag> tag_called(std::string_view name) {
  const std::size_t dash = name.rfind('-');
  if (dash == std::string_view::npos || family_called(name.substr(0, dash)) == nullptr) return std::nullopt;
  Tag out{std::string(name.substr(0, dash)), 0};
  const char* end = name.data() + name.size();
  const auto [read_to, error] = std::from_chars(name.data() + dash + 1, end, out.number);
  if (error != std::errc() || read_to != end || out.number < 0) return std::nullopt;
  return out;
}

// The whole image is looked at once; then what is around the square alone.
Result<std::optional<SeenMark>> tag_at(const cv::Mat& grey, cv::Point2d point) {
  const std::optional<Corners> square = square_around(grey, point);
  if (!square) return std::nullopt;
  const std::optional<Reading> read = read_large_tag(grey, around(*square, grey.size()), point);
  if (!read) return std::nullopt;
  std::optional<SeenMark> mark = whole_mark(grey, read->corners, *read->family, read->number);
  if (mark) return mark;
  return fail("unclear-tag",
              "the point is within a tag of which a part of the border is hidden or blurred: show the whole of it",
              list(point.x, point.y));
}

std::vector<SeenMark> find_tags(const cv::Mat& grey, const Tag& tag, cv::Rect area) {
  const TagFamily* family = family_called(tag.family);
  if (family == nullptr) return {};
  const cv::Rect whole({0, 0}, grey.size());
  const cv::Rect looked_at = area.empty() ? whole : area & whole;
  if (looked_at.empty()) return {};
  std::vector<SeenMark> out;
  TagDetection detection = detect_tags(grey(looked_at), *family);
  for (std::size_t i = 0; i < detection.found.size(); ++i) {
    if (detection.numbers[i] != tag.number) continue;
    move_by(detection.found[i], looked_at.tl());
    std::optional<SeenMark> mark = whole_mark(grey, detection.found[i], *family, tag.number);
    if (mark) out.push_back(std::move(*mark));
  }
  return out;
}

std::vector<SeenMark> follow_tag(const cv::Mat& grey, const Tag& tag, cv::Rect area) {
  const TagFamily* family = family_called(tag.family);
  const cv::Rect looked_at = area & cv::Rect({0, 0}, grey.size());
  if (family == nullptr || looked_at.empty()) return {};
  std::vector<SeenMark> out;
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family->dictionary);
  for (const TagSquare& square : tags_at_a_glance(grey, looked_at, *dictionary)) {
    if (square.number != tag.number) continue;
    std::optional<SeenMark> mark = whole_mark(grey, square.corners, *family, tag.number);
    if (mark) out.push_back(std::move(*mark));
  }
  return out.empty() ? find_tags(grey, tag, looked_at) : out;
}

cv::Rect area_around_tag(cv::Rect box) {
  constexpr int least_margin_px = 16;
  const int margin = std::max(least_margin_px, std::max(box.width, box.height) / 2);
  return {box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin};
}

bool are_tag_partners(const SeenMark& left, const SeenMark& right) {
  const double scale = right.height_px / left.height_px;
  return std::abs(left.centre.y - right.centre.y) < most_row_difference_px && left.centre.x > right.centre.x &&
         scale > 0.8 && scale < 1.25;
}

}  // namespace pizarra::vision
