#include "agents/vision/sight/follow_mark.hpp"

#include <algorithm>
#include <utility>

#include "agents/vision/marks/segmentation.hpp"

namespace pizarra::vision {
namespace {

// How far from its predicted place a mark is followed, in an image 320 px wide: more than a frame's motion (12 mm are
// 6 px).
constexpr int gate_px = 12;
constexpr int small_gate_px = 5;

// How far around the predicted place of its middle an image must be looked at for a mark to be followed there.
cv::Rect area_around(const SeenMark& last, cv::Point middle, int gate, cv::Size image) {
  const int reach_y = last.box.height / 2 + gate + 2 * MarkPatch::margin_px;
  // As many columns as fill whole vectors.
  const int reach_x = (last.box.width / 2 + gate + 2 * MarkPatch::margin_px + 7) / 8 * 8;
  return cv::Rect(middle.x - reach_x, middle.y - reach_y, 2 * reach_x, 2 * reach_y) & cv::Rect({0, 0}, image);
}

// Follows the contour of the mark that was `last` from about `centre`, no further than `gate_px` away.
std::optional<SeenMark> follow_mark(const cv::Mat& grey, double noise, const SeenMark& last, cv::Point2d centre,
                                    int gate) {
  const cv::Point middle(cvRound(centre.x), cvRound(centre.y));
  const cv::Rect area = area_around(last, middle, gate, grey.size());
  if (!area.contains(middle)) return std::nullopt;
  const ImageCut cut = look_at(grey, area, noise);
  const int threshold = cvRound((last.mark_level + last.ground_level) / 2);
  const ToneField field(cut.pixels, threshold, last.tone == MarkTone::dark);
  std::optional<MarkContour> contour =
      contour_from_centre(field, middle - area.tl(), gate, longest_contour_px(grey.size()));
  if (!contour || contour->size() < 4) return std::nullopt;
  std::optional<SeenMark> mark = measure_mark(cut, std::move(*contour), last.tone);
  if (!mark) return std::nullopt;
  move_by(*mark, cut.origin);
  mark->focal_px = last.focal_px;
  if (cv::norm(mark->centre - centre) > gate) return std::nullopt;
  return mark;
}

}  // namespace

// Converts px of an image 320 px wide into px of this one.
double px_in(const cv::Mat& image, double px) { return px * std::max(1.0, image.cols / 320.0); }

// Most marks are where they are expected; then little need be looked at.
std::optional<SeenMark> follow_mark(const cv::Mat& grey, double noise, const SeenMark& last, cv::Point2d centre) {
  std::optional<SeenMark> near = follow_mark(grey, noise, last, centre, cvRound(px_in(grey, small_gate_px)));
  if (!near) near = follow_mark(grey, noise, last, centre, cvRound(px_in(grey, gate_px)));
  return near;
}

}  // namespace pizarra::vision
