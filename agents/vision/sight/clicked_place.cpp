#include "agents/vision/sight/clicked_place.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tags.hpp"

namespace pizarra::vision {
namespace {

// Within one mark, in grey levels; or, where that is more, as a part of the lighter level, as light and shadow are.
constexpr double most_grey_change = 40;
constexpr double most_light_change = 0.4;
// How much of what lies beside a shape is unlike it; and how far beside, for blur.
constexpr double least_set_off = 0.8;
constexpr int beside_px = 3;
// In so many directions a point looks around itself. From outside nothing convex is seen in more than half of them.
constexpr int directions = 72;
constexpr double enclosing_share = 0.55;

// The pixels of `bits` that are connected with `seed`: 255.
cv::Mat1b connected(cv::Mat1b bits, cv::Point seed) {
  cv::Mat1b padded = cv::Mat1b::zeros(bits.rows + 2, bits.cols + 2);
  if (bits(seed) != 0) cv::floodFill(bits, padded, seed, 0, nullptr, 0, 0, 8 | cv::FLOODFILL_MASK_ONLY | (255 << 8));
  return padded(cv::Rect(1, 1, bits.cols, bits.rows)).clone();
}

// What a region encloses without being of it: 255.
cv::Mat1b enclosed(const cv::Mat1b& region) {
  cv::Mat1b out = cv::Mat1b::zeros(region.size());
  const cv::Rect box = cv::boundingRect(region);
  if (box.empty()) return out;
  cv::Mat1b around;
  cv::copyMakeBorder(region(box), around, 1, 1, 1, 1, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED, 0);
  cv::floodFill(around, cv::Point(0, 0), 255, nullptr, 0, 0, 4);
  out(box) = around(cv::Rect(1, 1, box.width, box.height)) == 0;
  return out;
}

bool reaches_border(const cv::Rect& box, cv::Size image) {
  return box.x <= 1 || box.y <= 1 || box.br().x >= image.width - 1 || box.br().y >= image.height - 1;
}

// The first pixel in a direction that is no ground; nothing where there is none within the image.
std::optional<cv::Point> first_seen(const cv::Mat1b& other, cv::Point from, double angle) {
  const cv::Rect image({}, other.size());
  for (int step = 1;; ++step) {
    const cv::Point at(cvRound(from.x + step * std::cos(angle)), cvRound(from.y + step * std::sin(angle)));
    if (!image.contains(at)) return std::nullopt;
    if (other(at) != 0) return at;
  }
}

// The box of the one thing that is seen from there in nearly all directions.
std::optional<cv::Rect> what_encloses(const cv::Mat1b& other, cv::Point from) {
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centres;
  const int count = cv::connectedComponentsWithStats(other, labels, stats, centres, 8, CV_32S);
  std::vector<int> seen(static_cast<std::size_t>(count));
  for (int i = 0; i < directions; ++i) {
    const std::optional<cv::Point> at = first_seen(other, from, 2 * CV_PI * i / directions);
    if (at) ++seen[static_cast<std::size_t>(labels(*at))];
  }
  const auto most = std::ranges::max_element(seen);
  if (*most < enclosing_share * directions) return std::nullopt;
  const auto label = static_cast<int>(most - seen.begin());
  return cv::Rect(stats(label, cv::CC_STAT_LEFT), stats(label, cv::CC_STAT_TOP), stats(label, cv::CC_STAT_WIDTH),
                  stats(label, cv::CC_STAT_HEIGHT));
}

}  // namespace

ClickedPlace::ClickedPlace(const cv::Mat& grey, cv::Point2d click)
    : grey_(grey), click_(click), seed_(cvRound(click.x), cvRound(click.y)), segmentation_(grey) {
  fill();
}

// The pixels of another level than the place where the filling began.
cv::Mat1b ClickedPlace::unlike() const {
  const cv::Mat1b& image = segmentation_.image();
  const cv::Rect about(seed_.x - 1, seed_.y - 1, 3, 3);
  const double begun_at = cv::mean(image(about & cv::Rect({}, image.size())))[0];
  cv::Mat1b levels(1, 256);
  for (int level = 0; level < 256; ++level) {
    const double most = std::max(most_grey_change, most_light_change * std::max<double>(level, begun_at));
    levels(level) = std::abs(level - begun_at) > most ? 255 : 0;
  }
  cv::Mat1b out;
  cv::LUT(image, levels, out);
  return out;
}

// The inside of a large mark has no tone: there the border is the first that has, to the left.
void ClickedPlace::fill() {
  const auto toned = [&](MarkTone tone, int x) { return segmentation_.bits(tone).inside(x, seed_.y); };
  int x = seed_.x;
  while (x > 0 && !toned(MarkTone::dark, x) && !toned(MarkTone::light, x)) --x;
  tone_ = toned(MarkTone::dark, x) ? MarkTone::dark : MarkTone::light;
  filled_ = connected(segmentation_.mask(tone_), {x, seed_.y});
  const cv::Mat1b hole = enclosed(filled_);
  other_px_ = cv::countNonZero(hole & unlike());
  if (filled_(seed_) == 0 && hole(seed_) == 0) {
    filled_.setTo(0);
  } else if (other_px_ < least_mark_area_px) {
    filled_ |= hole;
  }
}

Result<SeenMark> ClickedPlace::mark() {
  Result<std::optional<SeenMark>> tag = tag_at(grey_, click_);
  if (!tag) return fail(tag);
  if (*tag) return std::move(**tag);
  Result<SeenMark> solid = solid_mark();
  if (solid) return solid;
  // A shadow's edge within a large light mark is filled up to that edge; it is within the mark's contour all the same.
  std::optional<SeenMark> around = mark_around();
  if (around) return std::move(*around);
  return solid;
}

std::optional<SeenMark> ClickedPlace::mark_around() {
  const cv::Mat1b other = unlike();
  const SeenMark* smallest = nullptr;
  for (const SeenMark& mark : segmentation_.marks()) {
    if (cv::pointPolygonTest(mark.contour, cv::Point2f(click_), false) < 0) continue;
    cv::Mat1b inside = cv::Mat1b::zeros(other.size());
    cv::fillPoly(inside, std::vector<MarkContour>{mark.contour}, 255);
    const bool solid = cv::countNonZero(inside & other) < least_mark_area_px;
    if (solid && (smallest == nullptr || mark.area_px < smallest->area_px)) smallest = &mark;
  }
  return smallest == nullptr ? std::nullopt : std::optional(*smallest);
}

Result<SeenMark> ClickedPlace::solid_mark() {
  const int area = cv::countNonZero(filled_);
  if (area == 0 || 2 * cv::countNonZero(filled_ & unlike()) > area) return why_none();
  const cv::Rect box = cv::boundingRect(filled_);
  const bool cut = reaches_border(box, filled_.size());
  // Ground that has a mark in it has a hole; so has a ring, which is no solid mark either.
  const bool too_large = is_too_large_for_a_mark(box.size(), filled_.size());
  if ((too_large && cut) || other_px_ >= least_mark_area_px) return why_none();
  if (too_large) {
    return refuse("too-large",
                  "the shape around the point is wider or higher than nine tenths of the image: show it from "
                  "farther away");
  }
  if (!cut && area >= least_mark_area_px) {
    int x = box.x;
    while (filled_(box.y, x) == 0) ++x;
    const std::optional<MarkContour> contour =
        follow_contour(MaskField(filled_), {x, box.y}, longest_contour_px(filled_.size()));
    std::optional<SeenMark> mark;
    if (contour) mark = measure_mark(segmentation_.cut(), *contour, tone_);
    if (mark) return std::move(*mark);
  }
  if (!stands_out()) return why_none();
  if (cut) return refuse("border", "the shape around the point is cut by the border of the image");
  if (area < least_mark_area_px) return refuse("too-small", "the region around the point is too small");
  return refuse("open-contour", "the region around the point is no solid mark with a closed contour on even ground");
}

// Whether what is filled is unlike what lies beside it, all around.
bool ClickedPlace::stands_out() const {
  const auto grown = [&](int by) {
    cv::Mat1b out;
    cv::dilate(filled_, out, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * by + 1, 2 * by + 1}));
    return out;
  };
  const cv::Mat1b beside = grown(beside_px + 1) & ~grown(beside_px);
  return cv::countNonZero(beside & unlike()) >= least_set_off * cv::countNonZero(beside);
}

// The even area around the point is either the ground, or within an open contour, or a mark that leaks.
std::unexpected<Failure> ClickedPlace::why_none() const {
  const cv::Mat1b other = unlike();
  const cv::Mat1b even = connected(other == 0, seed_);
  const cv::Rect box = cv::boundingRect(even);
  const bool cut = reaches_border(box, even.size());
  const std::optional<cv::Rect> around = what_encloses(other, seed_);
  const bool leaks = around && (box | *around) != *around;
  const bool is_shape = !cut && cv::countNonZero(enclosed(even)) < least_mark_area_px;
  if (leaks || is_shape) {
    return refuse("open-contour", "the contour around the point is open: the filling leaks out of it");
  }
  if (around && cut) return refuse("border", "the shape around the point is cut by the border of the image");
  return refuse("background",
                "the point is on the ground, or on a ring: a mark is solid, and unlike the ground around it");
}

std::unexpected<Failure> ClickedPlace::refuse(const char* symbol, const char* sentence) const {
  return fail(symbol, sentence, list(click_.x, click_.y));
}

}  // namespace pizarra::vision
