#include "agents/vision/sight/mark_learner.hpp"

#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <span>

#include "agents/vision/marks/tags.hpp"
#include "agents/vision/objects/plane_look.hpp"
#include "agents/vision/sight/tag_pose.hpp"

namespace pizarra::vision {
namespace {

// In so many of the ten frames the mark must have been seen, and its contour closed.
constexpr std::size_t least_seen = 7;
// Where it moved no farther, frames can be averaged.
constexpr double rest_px = 1.5;

// Around a mark, for its outline's normals.
constexpr int portrait_margin_px = 8;

// Before one camera a square, whichever way it is turned. Nothing where the right image does not show it.
std::optional<FrontView> tag_from_front(StereoSight& sight, const SeenMark& seen) {
  const camera::StereoModel& model = sight.model();
  if (!model.is_single()) {
    const std::optional<SeenPair> pair = sight.find(*seen.tag, area_around_tag(seen.box));
    if (!pair || !pair->right) return std::nullopt;
    return view_from_front(model, face_plane(model, pair->left, *pair->right), to_image_of(pair->left));
  }
  const std::optional<TagPose> of_unit = tag_pose(model, seen.corners, 1);
  if (!of_unit) return std::nullopt;
  const double face_mm = face_of_square(model.learned_at_mm / of_unit->middle_mm[2]);
  return FrontView{face_mm * face_mm, 1, 180};
}

// A tag's portrait is that of a square: the values of the thesis' Table C.1, and the template picture. It is found by
// neither.
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

// An axis at 179 degrees is beside one at 1.
double mean_axis_deg(const std::vector<FrontView>& fronts) {
  constexpr double twice_rad = 2 * std::numbers::pi / 180;
  const double y = mean_of(fronts, [](const FrontView& front) { return std::sin(twice_rad * front.axis_deg); });
  const double x = mean_of(fronts, [](const FrontView& front) { return std::cos(twice_rad * front.axis_deg); });
  const double mean = std::atan2(y, x) / twice_rad;
  return mean > 0 ? mean : mean + 180;
}

// 255 within the contour.
cv::Mat1b inside(const MarkContour& contour, cv::Size image) {
  cv::Mat1b out = cv::Mat1b::zeros(image);
  cv::fillPoly(out, std::vector<MarkContour>{contour}, 255);
  return out;
}

// Whether the image shows that mark where it is now: nothing may come to lie under a click.
bool shows(const cv::Mat1b& grey, const SeenMark& mark) {
  const double level = cv::mean(grey, inside(mark.contour, grey.size()))[0];
  return std::abs(level - mark.mark_level) < std::abs(level - mark.ground_level);
}

// As it would be seen if it were turned as the one whose signatures these are.
cv::Mat1f turned_back(const cv::Mat1f& picture, const MarkSignature& seen, const TurnedSignatures& upright) {
  const double turn_deg = 360.0 * fit_signature(seen, upright).turn / TurnedSignatures::turns;
  constexpr float middle = template_size / 2.0F;
  cv::Mat1f out;
  cv::warpAffine(picture, out, cv::getRotationMatrix2D({middle, middle}, -turn_deg, 1), picture.size(),
                 cv::INTER_CUBIC);
  return out;
}

}  // namespace

Result<void> MarkLearner::feed(StereoSight& sight) {
  assert(!done());
  if (!filled_.empty() && filled_.size() != sight.left().size()) {
    return fail("wrong-size", "the camera came back with images of another size while the mark was learned",
                list(click_.x, click_.y));
  }
  return filled_frames_ < frames_per_step ? fill(sight) : measure(sight);
}

cv::Mat1b MarkLearner::filled_so_far() const {
  if (filled_.empty()) return {};
  std::vector<cv::Point> pixels;
  cv::findNonZero(filled_, pixels);
  const cv::Point from(click_);
  double furthest_px = 0;
  for (const cv::Point& pixel : pixels) furthest_px = std::max(furthest_px, cv::norm(pixel - from));
  cv::Mat1b reached(filled_.size(), 0);
  cv::circle(reached, from, cvCeil(furthest_px * filled_frames_ / frames_per_step), 255, cv::FILLED);
  return reached & filled_;
}

Result<void> MarkLearner::fill(StereoSight& sight) {
  const cv::Mat& left = sight.left();
  const bool first = filled_frames_ == 0;
  const bool last = ++filled_frames_ == frames_per_step;
  if (first && !cv::Rect({}, left.size()).contains({cvRound(click_.x), cvRound(click_.y)})) {
    return fail("outside", "the point is outside the image", list(click_.x, click_.y));
  }
  if (mark_ && !follow(sight)) return last ? end_filling() : Result<void>();
  add_up(left);
  if (mark_ && !last) {
    filled_ = inside(mark_->contour, left.size());
    return {};
  }
  cv::Mat mean;
  sum_.convertTo(mean, CV_8U, 1.0 / summed_);
  ClickedPlace place(mean, click_);
  filled_ = place.filled();
  if (!first && !last) return {};
  const Result<SeenMark> mark = place.mark();
  if (first && !mark) first_frame_ = left.clone();
  if (mark && (first || (!mark_ && shows(first_frame_, *mark)))) begin_following(sight, *mark);
  return last ? end_filling(sight, mark) : Result<void>();
}

// Noise may have kept one image from showing what their mean shows: a tag.
Result<void> MarkLearner::end_filling(StereoSight& sight, const Result<SeenMark>& mark) {
  const bool unclear = !mark && (!mark_ || mark.error().symbol == "unclear-tag");
  if (unclear) return fail(mark);
  if (mark && mark_ && mark->tag && mark->tag != mark_->tag) begin_following(sight, *mark);
  if (mark) contour_ = mark->contour;
  return end_filling();
}

// Of the frames in which the mark was where it is now.
void MarkLearner::add_up(const cv::Mat& left) {
  if (mark_ && cv::norm(mark_->centre - summed_at_) > rest_px) summed_ = 0;
  if (summed_ == 0) {
    left.convertTo(sum_, CV_16U);
  } else {
    cv::add(sum_, left, sum_, cv::noArray(), CV_16U);
  }
  if (summed_++ == 0 && mark_) summed_at_ = mark_->centre;
}

void MarkLearner::begin_following(StereoSight& sight, const SeenMark& mark) {
  mark_ = mark;
  seen_ = static_cast<std::size_t>(filled_frames_);
  summed_at_ = mark.centre;
  before_ = marked_image(sight.left(), marks_in(sight));
}

std::vector<SeenMark> MarkLearner::marks_in(StereoSight& sight) const {
  std::vector<SeenMark> out = sight.left_segmentation().marks();
  if (mark_->tag) {
    for (SeenMark& tag : find_tags(sight.left(), *mark_->tag)) out.push_back(std::move(tag));
  }
  return out;
}

bool MarkLearner::follow(StereoSight& sight) {
  MarkedImage now = marked_image(sight.left(), marks_in(sight));
  const Refound found = refind(*mark_, before_, now);
  ambiguous_ = ambiguous_ || found.ambiguous;
  if (found.mark == nullptr) {
    crowded_ = crowded_ || sight.left_segmentation().left_out() > 0;
    return false;
  }
  moved_ = moved_ || cv::norm(found.mark->centre - mark_->centre) > rest_px;
  click_ += found.mark->centre - mark_->centre;
  mark_ = *found.mark;
  before_ = std::move(now);
  ++seen_;
  return true;
}

Result<void> MarkLearner::end_filling() {
  if (!mark_) {
    return fail("moved", "the mark around the point came there while it was filled", list(click_.x, click_.y));
  }
  const Result<void> followed = check_seen(seen_);
  if (!followed) return followed;
  if (contour_.empty()) contour_ = mark_->contour;
  return check_kind();
}

// An object is found by its shape or by its tag, and by one tag alone.
Result<void> MarkLearner::check_kind() const {
  const LearnedObject* object = objects_.find(name_);
  if (object == nullptr) return {};
  const Tag* known = object->tag();
  if (known != nullptr && mark_->tag == *known) return {};
  if (known == nullptr && !mark_->tag) return {};
  const std::string sentence = known == nullptr ? "a shape is learned under this name, and this is a tag"
                               : mark_->tag
                                   ? fmt::format("another tag is learned under this name, {}", tag_name(*known))
                                   : "a tag is learned under this name, and this is a shape";
  return fail("other-kind", sentence, to_datum(object->name));
}

Result<void> MarkLearner::measure(StereoSight& sight) {
  ++contour_frames_;
  model_ = sight.model();
  if (follow(sight)) {
    contour_ = mark_->contour;
    measured_.push_back(*mark_);
    portraits_.push_back(mark_->tag ? portrait_of_tag(sight.left(), *mark_)
                                    : portray_mark(sight.left_segmentation().cut(), contour_, mark_->tone).value());
    look_from_front(sight, *mark_);
  }
  return done() ? check_measured() : Result<void>{};
}

// By the plane that both images show; before one camera alone as it looks, by where objects are said to be while they
// are learned.
std::optional<FrontView> MarkLearner::front_of(const std::optional<FacePlane>& plane,
                                               const cv::Matx22d& to_image) const {
  if (plane) return view_from_front(model_, *plane, to_image);
  if (!model_.is_single()) return std::nullopt;
  return view_as_seen(to_image, model_.learned_at_mm / model_.focal_px);
}

void MarkLearner::look_from_front(StereoSight& sight, const SeenMark& seen) {
  if (seen.tag) {
    const std::optional<FrontView> front = tag_from_front(sight, seen);
    if (front) fronts_.push_back(*front);
    return;
  }
  std::optional<FacePlane> plane;
  const SeenMark* partner = nullptr;
  if (!model_.is_single()) partner = find_partner(seen, sight.right_segmentation().marks(), std::nullopt);
  if (partner != nullptr) plane = face_plane(model_, seen, *partner);
  const cv::Matx22d to_image = to_image_of(seen);
  if (const std::optional<FrontView> front = front_of(plane, to_image)) fronts_.push_back(*front);
  const ImageCut& cut = sight.left_segmentation().cut();
  const cv::Point beside(portrait_margin_px, portrait_margin_px);
  const cv::Rect around(seen.box.tl() - cut.origin - beside, seen.box.br() - cut.origin + beside);
  const cv::Rect box = around & cv::Rect({}, cut.pixels.size());
  const cv::Point2d middle = seen.centre - cv::Point2d(cut.origin + box.tl());
  portrayed_.push_back({cut.pixels(box).clone(),
                        {to_image(0, 0), to_image(0, 1), middle.x, to_image(1, 0), to_image(1, 1), middle.y, 0, 0, 1},
                        plane});
}

// How the picture leads to the image, by the edges of its outline there. Blur and the template's pixels change the
// picture and its second moments alike, and these edges hardly. A triangle's three sides leave perspective open, which
// would change their slope: its moments say it.
std::optional<cv::Matx22d> MarkLearner::registered(const LearnedSample& sample, const Portrayed& frame) {
  if (is_triangle(sample.outlines.front())) return frame.from_picture.get_minor<2, 2>(0, 0);
  const std::optional<PlaneFit> fit = fit_plane(frame.pixels, sample.plane, frame.from_picture, sample.tone);
  return fit && is_outline_of(*fit) ? std::optional(fit->slope()) : std::nullopt;
}

// The picture of a mark that moved meanwhile is turned as in the first frame.
std::vector<FrontView> MarkLearner::fronts_by_outline(const LearnedSample& sample) const {
  std::vector<FrontView> out;
  for (const Portrayed& frame : std::span(portrayed_).first(moved_ ? 1 : portrayed_.size())) {
    const std::optional<cv::Matx22d> to_image = registered(sample, frame);
    const std::optional<FrontView> front = to_image ? front_of(frame.plane, *to_image) : std::nullopt;
    if (front) out.push_back(*front);
  }
  return out;
}

Result<void> MarkLearner::check_seen(std::size_t frames) const {
  if (frames >= least_seen) return {};
  const Datum where = list(click_.x, click_.y);
  if (crowded_) {
    return fail(
        "crowded",
        fmt::format("the mark is none of the {} largest in the image, and smaller ones are not looked at", most_marks),
        where);
  }
  if (ambiguous_) {
    return fail("ambiguous",
                "shapes like it are near, and the images moved so that nobody can tell which of them was clicked on",
                where);
  }
  return fail("moved", "the mark moved too far, or its contour did not stay closed, while it was learned", where);
}

Result<void> MarkLearner::check_measured() const {
  const Result<void> seen = check_seen(measured_.size());
  if (!seen) return seen;
  for (const LearnedObject& other : objects_.all()) {
    if (same_name(other.name, name_)) continue;
    if (recognition_error(measured_.back(), other) < recognition_threshold / 2) {
      return fail("ambiguous", "the mark looks like one that is learned under another name", to_datum(other.name));
    }
  }
  return {};
}

// Of portraits that are turned alike.
cv::Mat1f MarkLearner::mean_picture() const {
  const bool turns = moved_ && !mark_->tag;
  const TurnedSignatures upright = turned_signatures_of(template_from_picture(portraits_.front().picture));
  cv::Mat1f out = cv::Mat1f::zeros(template_size, template_size);
  for (std::size_t i = 0; i < portraits_.size(); ++i) {
    const cv::Mat1f& picture = portraits_[i].picture;
    out += turns && i > 0 ? turned_back(picture, measured_[i].signature, upright) : picture;
  }
  return out / static_cast<double>(portraits_.size());
}

LearnedSample MarkLearner::sample() const {
  assert(done() && !measured_.empty());
  LearnedSample out;
  out.tone = measured_.front().tone;
  out.tag = measured_.front().tag;
  out.area_px = mean_of(measured_, [](const SeenMark& m) { return m.area_px; });
  out.perimeter_px =
      static_cast<int>(std::lround(mean_of(measured_, [](const SeenMark& m) { return m.perimeter_px; })));
  out.corners = static_cast<int>(std::lround(mean_of(portraits_, [](const MarkPortrait& p) { return p.corners; })));
  for (std::size_t i = 0; i < out.moments.size(); ++i) {
    out.moments[i] = mean_of(portraits_, [i](const MarkPortrait& p) { return p.moments[i]; });
  }
  out.height_px = mean_of(measured_, [](const SeenMark& m) { return m.height_px; });
  out.focal_px = model_.focal_px;
  if (!out.tag) out.contrast = mean_of(measured_, print_contrast);
  out.slimness = mean_of(measured_, [](const SeenMark& m) { return m.slimness; });
  out.roundness = mean_of(measured_, [](const SeenMark& m) { return m.roundness; });
  out.roundness_spread = std::sqrt(mean_of(measured_, [&](const SeenMark& m) {
    const double off = m.roundness - out.roundness;
    return off * off;
  }));
  const auto area_of = [](const FrontView& front) { return front.area_mm2; };
  const auto slimness_of = [](const FrontView& front) { return front.slimness; };
  if (2 * fronts_.size() > measured_.size()) {
    out.size_mm = std::sqrt(mean_of(fronts_, area_of));
    out.size_by = model_.is_single() ? LearnedSample::SizeBy::guessed_face : LearnedSample::SizeBy::measured_face;
    out.slimness = mean_of(fronts_, slimness_of);
  }
  out.set_picture(template_from_picture(mean_picture()));
  const bool has_axis = !out.tag && (out.is_slim() || !is_regular(out.outlines.front()));
  const std::vector<FrontView> by_outline = has_axis ? fronts_by_outline(out) : std::vector<FrontView>();
  if (by_outline.empty()) return out;
  if (model_.is_single()) out.size_mm = std::sqrt(mean_of(by_outline, area_of));
  out.slimness = mean_of(by_outline, slimness_of);
  out.axis_deg = mean_axis_deg(by_outline);
  return out;
}

}  // namespace pizarra::vision
