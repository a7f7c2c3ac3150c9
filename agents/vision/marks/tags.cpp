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

using Corners = TagCorners;

void move_by(Corners& corners, cv::Point origin) {
  for (cv::Point2f& p : corners) p += cv::Point2f(origin);
}

cv::Rect around(const Corners& corners, cv::Size image) {
  const int margin = cvCeil(margin_of_side * side_px(corners)) + 2;
  const cv::Rect box = cv::boundingRect(corners);
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
         cv::Rect({0, 0}, image);
}

bool is_around(const Corners& corners, cv::Point2d point) {
  return cv::pointPolygonTest(corners, cv::Point2f(point), false) >= 0;
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
      const double like = tag_likeness(grey, corners, *dictionary, detection.numbers[i]);
      if (like <= (best ? best->likeness : least_tag_likeness)) continue;
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
  std::optional<SeenMark> mark = whole_tag(grey, read->corners, *read->family, read->number);
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
    std::optional<SeenMark> mark = whole_tag(grey, detection.found[i], *family, tag.number);
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
