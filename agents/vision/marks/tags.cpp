#include "agents/vision/marks/tags.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/marks/tag_mark.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

constexpr double most_row_difference_px = 2;
// Around a tag there must be light for its border to be seen.
constexpr double margin_of_side = 0.35;
// A wide tag's cells end at most so far from its middle, as a part of the half of its square's side; and so far beyond
// the square.
constexpr double wide_reach = 9.0 / 5;
constexpr double wide_margin_of_side = (wide_reach - 1) / 2;

using Corners = TagCorners;

void move_by(Corners& corners, cv::Point origin) {
  for (cv::Point2f& p : corners) p += cv::Point2f(origin);
}

cv::Rect around(const Corners& corners, cv::Size image, bool wide) {
  const double of_side = margin_of_side + (wide ? wide_margin_of_side : 0);
  const int margin = cvCeil(of_side * side_px(corners)) + 2;
  const cv::Rect box = cv::boundingRect(corners);
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
         cv::Rect({0, 0}, image);
}

// An area in which a wide tag's square is, and what of the tag is around that.
cv::Rect with_wide_margin(cv::Rect area) {
  const int margin = cvCeil(wide_margin_of_side * std::min(area.width, area.height));
  return area.empty() ? area : area + cv::Size(2 * margin, 2 * margin) - cv::Point(margin, margin);
}

// Whether the point is on the tag that has these corners.
bool is_around(Corners corners, cv::Point2d point, bool wide) {
  if (wide) {
    const cv::Point2f middle = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    for (cv::Point2f& corner : corners) corner = middle + wide_reach * (corner - middle);
  }
  return cv::pointPolygonTest(corners, cv::Point2f(point), false) >= 0;
}

// The largest square around the point, whether a tag of that family or not: light cells may be squares too. With `wide`
// the largest that may be a wide tag's.
std::optional<Corners> square_around(const cv::Mat& grey, cv::Point2d point, double least_around, bool wide) {
  const TagDetection detection = detect_tags(grey, tag_families().front(), least_around);
  std::optional<Corners> best;
  for (const auto* squares : {&detection.found, &detection.others}) {
    for (const Corners& corners : *squares) {
      if (!is_around(corners, point, wide)) continue;
      if (wide && !has_a_border(grey, corners, tag_families().back())) continue;
      if (!best || cv::contourArea(corners) > cv::contourArea(*best)) best = corners;
    }
  }
  return best;
}

// In an image as large as a photograph what is large is seen in a smaller image as well, and what is small around a
// point is near it.
std::optional<Corners> square_around(const cv::Mat& grey, cv::Point2d point, bool wide) {
  constexpr int plenty_px = 1280;
  constexpr int reach_px = 128;  // of the smaller image
  const int parts = (std::max(grey.cols, grey.rows) + plenty_px - 1) / plenty_px;
  if (parts == 1) return square_around(grey, point, 0.03, wide);
  cv::Mat smaller;
  cv::resize(grey, smaller, {}, 1.0 / parts, 1.0 / parts, cv::INTER_AREA);
  std::optional<Corners> large = square_around(smaller, point / parts, 0.2, wide);
  if (large) std::ranges::for_each(*large, [&](cv::Point2f& p) { p *= parts; });
  const int reach = reach_px * parts;
  const cv::Rect near =
      cv::Rect(cvRound(point.x) - reach, cvRound(point.y) - reach, 2 * reach, 2 * reach) & cv::Rect({}, grey.size());
  std::optional<Corners> small = square_around(grey(near), point - cv::Point2d(near.tl()), 0.12, wide);
  if (small) move_by(*small, near.tl());
  return !small || (large && cv::contourArea(*large) > cv::contourArea(*small)) ? large : small;
}

struct Reading {
  const TagFamily* family;
  int number;
  Corners corners;
  double likeness;
};

// The tag around the point, of whatever of these families. Several families may read one tag, some by mending cells:
// the likest reading is taken, the first of equal ones.
std::optional<Reading> read_tag(const cv::Mat& grey, cv::Rect area, cv::Point2d point,
                                std::span<const TagFamily> considered) {
  std::optional<Reading> best;
  for (const TagFamily& family : considered) {
    TagDetection detection = detect_tags(grey(area), family);
    for (std::size_t i = 0; i < detection.found.size(); ++i) {
      Corners& corners = detection.found[i];
      move_by(corners, area.tl());
      if (!is_around(corners, point, family.is_wide()) || !has_a_border(grey, corners, family)) continue;
      const double like = tag_likeness(grey, corners, family, detection.numbers[i]);
      if (like <= (best ? best->likeness : least_tag_likeness(family))) continue;
      best = Reading{&family, detection.numbers[i], std::move(corners), like};
    }
  }
  return best;
}

// Each family is tried in no larger an image than it takes; the one that it is looks at the pixels.
std::optional<Reading> read_large_tag(const cv::Mat& grey, cv::Rect area, cv::Point2d point,
                                      std::span<const TagFamily> considered) {
  constexpr int plenty_px = 640;
  const int parts = (std::max(area.width, area.height) + plenty_px - 1) / plenty_px;
  if (parts == 1) return read_tag(grey, area, point, considered);
  cv::Mat smaller;
  cv::resize(grey(area), smaller, {}, 1.0 / parts, 1.0 / parts, cv::INTER_AREA);
  const cv::Point2d within = point - cv::Point2d(area.tl());
  const std::optional<Reading> what = read_tag(smaller, {{}, smaller.size()}, within / parts, considered);
  return what ? read_tag(grey, area, point, {what->family, 1}) : std::nullopt;
}

// The whole image is looked at once; then what is around the square alone.
std::optional<Reading> read_around(const cv::Mat& grey, cv::Point2d point, bool wide) {
  const std::optional<Corners> square = square_around(grey, point, wide);
  if (!square) return std::nullopt;
  const auto first_wide = std::ranges::find_if(tag_families(), &TagFamily::is_wide);
  const std::span<const TagFamily> considered =
      wide ? std::span(first_wide, tag_families().end()) : std::span(tag_families().begin(), first_wide);
  return read_large_tag(grey, around(*square, grey.size(), wide), point, considered);
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

Result<std::optional<SeenMark>> tag_at(const cv::Mat& grey, cv::Point2d point) {
  std::optional<Reading> read = read_around(grey, point, false);
  if (!read) read = read_around(grey, point, true);
  if (!read) return std::nullopt;
  std::optional<SeenMark> mark = whole_tag(grey, read->corners, *read->family, read->number);
  if (mark) return mark;
  return fail("unclear-tag",
              "the point is within a tag of which a part of the border is hidden or blurred: show the whole of it",
              list(point.x, point.y));
}

std::vector<SeenMark> find_tags(const cv::Mat& grey, const Tag& tag, cv::Rect area) {
  const TagFamily* family = family_called(tag.family);
  if (family == nullptr) return {};
  return tags_among(grey, squares_in(grey, *family, area), tag);
}

TagDetection squares_in(const cv::Mat& grey, const TagFamily& family, cv::Rect area) {
  const cv::Rect whole({0, 0}, grey.size());
  if (family.is_wide()) area = with_wide_margin(area);
  const cv::Rect looked_at = area.empty() ? whole : area & whole;
  if (looked_at.empty()) return {};
  const cv::Mat pixels = grey(looked_at);
  TagDetection out =
      family.is_wide() ? detect_tags(pixels, family) : detect_all_tags(pixels, family, squares_at_levels(pixels));
  for (auto* squares : {&out.found, &out.others}) {
    for (Corners& corners : *squares) move_by(corners, looked_at.tl());
  }
  return out;
}

std::vector<SeenMark> tags_among(const cv::Mat& grey, const TagDetection& squares, const Tag& tag) {
  const TagFamily* family = family_called(tag.family);
  std::vector<SeenMark> out;
  for (std::size_t i = 0; family != nullptr && i < squares.found.size(); ++i) {
    if (squares.numbers[i] != tag.number) continue;
    std::optional<SeenMark> mark = whole_tag(grey, squares.found[i], *family, tag.number);
    if (mark) out.push_back(std::move(*mark));
  }
  return out;
}

std::vector<SeenMark> follow_tag(const cv::Mat& grey, const Tag& tag, cv::Rect area) {
  const TagFamily* family = family_called(tag.family);
  const cv::Rect looked_at = area & cv::Rect({0, 0}, grey.size());
  if (family == nullptr || looked_at.empty()) return {};
  if (family->is_wide()) return find_tags(grey, tag, area);
  std::vector<SeenMark> out;
  for (const TagSquare& square : tags_at_a_glance(grey, looked_at, *dictionary_of(*family))) {
    if (square.number != tag.number) continue;
    std::optional<SeenMark> mark = whole_tag(grey, square.corners, *family, tag.number);
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
