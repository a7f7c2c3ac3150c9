#include "agents/vision/sight/mark_learner.hpp"

#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tags.hpp"

namespace pizarra {
namespace {

// A closed contour must have been followed in this many of the ten frames.
constexpr std::size_t least_measured = 7;
constexpr double most_motion_px = 1.5;
// Within one mark, in grey levels; or, where that is more, as a part of the lighter level, as light and shadow are.
constexpr double most_grey_change = 40;
constexpr double most_light_change = 0.4;

// In the world, by the partner; or, before one camera alone, by where objects are said to be while they are learned.
std::optional<double> size_mm(StereoSight& sight, const SeenMark& seen) {
  const StereoModel& model = sight.model();
  if (model.is_single()) return seen.height_px * model.learned_at_mm / model.focal_px;
  const SeenMark* partner = find_partner(seen, sight.right_segmentation().marks(), std::nullopt);
  if (partner == nullptr) return std::nullopt;
  return size_mm(model, seen, *partner);
}

// What the thesis' Table C.1 and the template picture say of a square; a tag is found by neither.
MarkPortrait portrait_of_tag(const cv::Mat& grey, const SeenMark& seen) {
  MarkPortrait out{.corners = 4, .picture = {}};
  cv::Mat small;
  cv::resize(grey(seen.box & cv::Rect({0, 0}, grey.size())), small, {template_size, template_size}, 0, 0,
             cv::INTER_AREA);
  // How much of each place is dark.
  small.convertTo(out.picture, CV_32F, -1.0 / 255, 1);
  out.moments[0] = seen.roundness;
  return out;
}

template <typename Measured>
double mean_of(const std::vector<Measured>& measured, auto value) {
  const double sum = std::accumulate(measured.begin(), measured.end(), 0.0,
                                     [&](double so_far, const Measured& m) { return so_far + value(m); });
  return sum / static_cast<double>(measured.size());
}

// What is of another level than the place where the filling began.
cv::Mat1b unlike(const cv::Mat1b& image, cv::Point seed) {
  const double begun_at = cv::mean(image(cv::Rect(seed.x - 1, seed.y - 1, 3, 3) & cv::Rect({}, image.size())))[0];
  cv::Mat1b levels(1, 256);
  for (int level = 0; level < 256; ++level) {
    const double most = std::max(most_grey_change, most_light_change * std::max<double>(level, begun_at));
    levels(level) = std::abs(level - begun_at) > most ? 255 : 0;
  }
  cv::Mat1b out;
  cv::LUT(image, levels, out);
  return out;
}

// The pixels of `bits` that are connected with `seed`: 255.
cv::Mat1b connected(cv::Mat1b bits, cv::Point seed) {
  cv::Mat1b padded = cv::Mat1b::zeros(bits.rows + 2, bits.cols + 2);
  if (bits(seed) != 0) cv::floodFill(bits, padded, seed, 0, nullptr, 0, 0, 8 | cv::FLOODFILL_MASK_ONLY | (255 << 8));
  return padded(cv::Rect(1, 1, bits.cols, bits.rows)).clone();
}

// What a region encloses without being of it: 255.
cv::Mat1b enclosed(const cv::Mat1b& region) {
  cv::Mat1b around;
  cv::copyMakeBorder(region, around, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  cv::floodFill(around, cv::Point(0, 0), 255, nullptr, 0, 0, 4);
  return around(cv::Rect(1, 1, region.cols, region.rows)) == 0;
}

}  // namespace

Result<void> MarkLearner::feed(StereoSight& sight) {
  assert(!done());
  if (!filled_.empty() && filled_.size() != sight.left().size()) {
    return fail("wrong-size", "the camera came back with images of another size while the mark was learned",
                list(click_.x, click_.y));
  }
  if (filled_frames_ < frames_per_step) return fill(sight.left());
  return measure(sight);
}

Result<void> MarkLearner::fill(const cv::Mat& left) {
  const cv::Point seed(cvRound(click_.x), cvRound(click_.y));
  if (!cv::Rect(0, 0, left.cols, left.rows).contains(seed)) {
    return fail("outside", "the point is outside the image", list(click_.x, click_.y));
  }
  cv::Mat1f grey;
  left.convertTo(grey, CV_32F);
  if (sum_.empty()) {
    sum_ = grey;
  } else {
    sum_ += grey;
  }
  ++filled_frames_;
  cv::Mat mean;
  sum_.convertTo(mean, CV_8U, 1.0 / filled_frames_);
  ImageSegmentation segmentation(mean);
  fill(segmentation, seed);
  if (filled_frames_ < frames_per_step) return {};
  Result<std::optional<SeenMark>> tag = tag_at(mean, click_);
  if (!tag) return fail(tag);
  first_ = std::move(*tag);
  if (first_) {
    contour_ = first_->contour;
    return check_kind();
  }
  const Result<void> checked = check_region(segmentation);
  // A shadow's edge within a large light mark is filled up to that edge; it is within the mark's contour all the same.
  return checked || is_within_a_mark(segmentation) ? check_kind() : checked;
}

// An object is found by its shape or by its tag, and by one tag alone.
Result<void> MarkLearner::check_kind() const {
  const LearnedObject* object = objects_.find(name_);
  if (object == nullptr) return {};
  const Tag* known = object->tag();
  if (known != nullptr && first_->tag == *known) return {};
  if (known == nullptr && !first_->tag) return {};
  const std::string sentence = known == nullptr ? "a shape is learned under this name, and this is a tag"
                               : first_->tag
                                   ? fmt::format("another tag is learned under this name, {}", tag_name(*known))
                                   : "a tag is learned under this name, and this is a shape";
  return fail("other-kind", sentence, to_datum(object->name));
}

bool MarkLearner::is_within_a_mark(ImageSegmentation& mean) {
  const cv::Mat1b other = unlike(mean.image(), {cvRound(click_.x), cvRound(click_.y)});
  for (const SeenMark& mark : mean.marks()) {
    if (cv::pointPolygonTest(mark.contour, cv::Point2f(click_), false) < 0) continue;
    cv::Mat1b inside = cv::Mat1b::zeros(other.size());
    cv::fillPoly(inside, std::vector<MarkContour>{mark.contour}, 255);
    const bool solid = cv::countNonZero(inside & other) < least_mark_area_px;
    if (solid && (!first_ || mark.area_px < first_->area_px)) first_ = mark;
  }
  if (first_) contour_ = first_->contour;
  return first_.has_value();
}

// The inside of a large mark has no tone: there the border is the first that has, to the left.
void MarkLearner::fill(const ImageSegmentation& mean, cv::Point seed) {
  const auto toned = [&](MarkTone tone, int x) { return mean.bits(tone).inside(x, seed.y); };
  int x = seed.x;
  while (x > 0 && !toned(MarkTone::dark, x) && !toned(MarkTone::light, x)) --x;
  tone_ = toned(MarkTone::dark, x) ? MarkTone::dark : MarkTone::light;
  filled_ = connected(mean.mask(tone_), {x, seed.y});
  const cv::Mat1b hole = enclosed(filled_);
  other_px_ = cv::countNonZero(hole & unlike(mean.image(), seed));
  if (filled_(seed) == 0 && hole(seed) == 0) {
    filled_.setTo(0);
  } else if (other_px_ < least_mark_area_px) {
    filled_ |= hole;
  }
}

Result<void> MarkLearner::check_region(const ImageSegmentation& mean) {
  const Datum where = list(click_.x, click_.y);
  const int area = cv::countNonZero(filled_);
  if (area == 0)
    return fail(
        "background",
        "there is nothing but even ground around the point, or the inside of a shape that the image's border cuts",
        where);
  const cv::Rect box = cv::boundingRect(filled_);
  const bool cut = box.x <= 1 || box.y <= 1 || box.br().x >= filled_.cols - 1 || box.br().y >= filled_.rows - 1;
  const cv::Point seed(cvRound(click_.x), cvRound(click_.y));
  if (2 * cv::countNonZero(filled_ & unlike(mean.image(), seed)) > area) {
    return fail("open-contour", "the contour of the mark is open: what is filled leaks out of it", where);
  }
  // Ground that has a mark in it has a hole; so has a ring, which is no solid mark either.
  const bool too_large = is_too_large_for_a_mark(box.size(), filled_.size());
  if ((too_large && cut) || other_px_ >= least_mark_area_px) {
    return fail("background", "the point is on the ground around marks, which is no mark itself", where);
  }
  if (too_large) {
    return fail("too-large",
                "the shape around the point is wider or higher than nine tenths of the image: show it from "
                "farther away",
                where);
  }
  if (cut) return fail("border", "the shape around the point is cut by the border of the image", where);
  if (area < least_mark_area_px) return fail("too-small", "the region around the point is too small", where);
  int x = box.x;
  while (filled_(box.y, x) == 0) ++x;
  const std::optional<MarkContour> contour =
      follow_contour(MaskField(filled_), {x, box.y}, longest_contour_px(filled_.size()));
  if (contour) first_ = measure_mark(mean.cut(), *contour, tone_);
  if (!first_) {
    return fail("open-contour", "the region around the point is no solid mark with a closed contour on even ground",
                where);
  }
  contour_ = *contour;
  return {};
}

Result<void> MarkLearner::measure(StereoSight& sight) {
  ++contour_frames_;
  size_guessed_ = sight.model().is_single();
  if (first_->tag) {
    measure_tag(sight);
    return done() ? check_measured() : Result<void>{};
  }
  const SeenMark* seen = nullptr;
  ImageSegmentation& segmentation = sight.left_segmentation();
  for (const SeenMark& mark : segmentation.marks()) {
    if (mark.tone == first_->tone && cv::norm(mark.centre - first_->centre) < most_motion_px) seen = &mark;
  }
  if (seen != nullptr) {
    contour_ = seen->contour;
    const std::optional<MarkPortrait> portrait = portray_mark(segmentation.cut(), seen->contour, seen->tone);
    measured_.push_back(*seen);
    portraits_.push_back(portrait.value());
    const std::optional<double> size = size_mm(sight, *seen);
    if (size) sizes_mm_.push_back(*size);
  } else if (segmentation.left_out() > 0) {
    crowded_ = true;
  }
  return done() ? check_measured() : Result<void>{};
}

void MarkLearner::measure_tag(StereoSight& sight) {
  const std::optional<SeenPair> seen = sight.find(*first_->tag, area_around_tag(first_->box));
  if (!seen || cv::norm(seen->left.centre - first_->centre) > most_motion_px) return;
  measured_.push_back(seen->left);
  portraits_.push_back(portrait_of_tag(sight.left(), seen->left));
  const StereoModel& model = sight.model();
  if (model.is_single()) {
    sizes_mm_.push_back(seen->left.height_px * model.learned_at_mm / model.focal_px);
  } else if (seen->right) {
    sizes_mm_.push_back(size_mm(model, seen->left, *seen->right));
  }
}

Result<void> MarkLearner::check_measured() const {
  const Datum where = list(click_.x, click_.y);
  if (measured_.size() < least_measured && crowded_) {
    return fail(
        "crowded",
        fmt::format("the mark is none of the {} largest in the image, and smaller ones are not looked at", most_marks),
        where);
  }
  if (measured_.size() < least_measured) {
    return fail("moved", "the mark moved, or its contour did not stay closed, while it was learned", where);
  }
  for (const LearnedObject& other : objects_.all()) {
    if (same_name(other.name, name_)) continue;
    if (recognition_error(measured_.back(), other) < recognition_threshold / 2) {
      return fail("ambiguous", "the mark looks like one that is learned under another name", to_datum(other.name));
    }
  }
  return {};
}

LearnedSample MarkLearner::sample() const {
  assert(done() && !measured_.empty());
  LearnedSample out;
  out.tone = first_->tone;
  out.tag = first_->tag;
  out.area_px = mean_of(measured_, [](const SeenMark& m) { return m.area_px; });
  out.perimeter_px =
      static_cast<int>(std::lround(mean_of(measured_, [](const SeenMark& m) { return m.perimeter_px; })));
  out.corners = static_cast<int>(std::lround(mean_of(portraits_, [](const MarkPortrait& p) { return p.corners; })));
  for (std::size_t i = 0; i < out.moments.size(); ++i) {
    out.moments[i] = mean_of(portraits_, [i](const MarkPortrait& p) { return p.moments[i]; });
  }
  out.height_px = mean_of(measured_, [](const SeenMark& m) { return m.height_px; });
  out.slimness = mean_of(measured_, [](const SeenMark& m) { return m.slimness; });
  out.roundness = mean_of(measured_, [](const SeenMark& m) { return m.roundness; });
  out.roundness_spread = std::sqrt(mean_of(measured_, [&](const SeenMark& m) {
    const double off = m.roundness - out.roundness;
    return off * off;
  }));
  if (2 * sizes_mm_.size() > measured_.size()) {
    out.size_mm = std::accumulate(sizes_mm_.begin(), sizes_mm_.end(), 0.0) / static_cast<double>(sizes_mm_.size());
    out.size_guessed = size_guessed_;
  }
  cv::Mat1f picture = cv::Mat1f::zeros(template_size, template_size);
  for (const MarkPortrait& portrait : portraits_) picture += portrait.picture;
  picture /= static_cast<double>(portraits_.size());
  out.set_picture(template_from_picture(picture));
  return out;
}

}  // namespace pizarra
