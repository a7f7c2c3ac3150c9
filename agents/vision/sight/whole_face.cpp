#include "agents/vision/sight/whole_face.hpp"

#include <algorithm>
#include <cmath>

#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/face_plane.hpp"
#include "agents/vision/sight/unyawed.hpp"

namespace pizarra::vision {
namespace {

// How far the light's slope and the blur change a length, as a part of it.
constexpr double length_spread = 0.003;
// How far a length drifts, as a part of it, where the mark moves by its own width; farther by the root.
constexpr double drift = 0.0075;
// But no more anywhere.
constexpr double most_drift = 0.02;
// Where edges run along the pixels and fall between two, blur reaches into what is taken for ground: the contrast is
// less, and every length by so much of the part that is lost. What loses more is in another light.
constexpr double narrowing = 0.25;
constexpr double most_lost_contrast = 0.1;
// How much of a new contrast the memory takes over.
constexpr double contrast_gain = 0.1;
// And of how much of the width is shown.
constexpr double shown_gain = 0.3;
// In standard deviations: what noise makes, and what it hardly makes.
constexpr double likely = 2;
constexpr double clear = 3;

double squared(double x) { return x * x; }

double length(double a, double b) { return std::sqrt(a * a + b * b); }

double contrast_of(const SeenMark& mark) { return std::abs(mark.mark_level - mark.ground_level); }

double deviations(const FaceSize::Reading& whole, const FaceSize::Reading& now) {
  return (now.value / whole.value - 1) / std::sqrt(squared(whole.spread) + squared(now.spread));
}

// Both weighed by how sure they are (R. E. Kalman, A new approach to linear filtering and prediction problems, 1960).
// What is smaller is taken as it is; what is clearly larger may be one image's part of it, which looks nearer, and
// counts no more than what noise makes.
FaceSize::Reading followed(const FaceSize::Reading& whole, const FaceSize::Reading& now) {
  const double off = deviations(whole, now);
  if (off < -clear) return now;
  const double part = off > clear ? clear / off : 1;
  const double gain = squared(whole.spread) / (squared(whole.spread) + squared(now.spread));
  return {whole.value + part * gain * (now.value - whole.value), std::sqrt(1 - gain) * whole.spread};
}

}  // namespace

FaceSize if_not_tilted(FaceSize size) {
  size.area_mm2.value /= size.area_by_tilt;
  size.size_mm.value /= size.size_by_tilt;
  return size;
}

double missing(double whole, const FaceSize::Reading& now, double slack) {
  return 1 - now.value / whole - now.spread - slack;
}

// An image shows so much of the area as the line of sight has of the normal.
FaceSize face_size(const camera::StereoModel& model, const SeenMark& left, const SeenMark& right,
                   double front_slimness) {
  const FacePlane plane = face_plane(model, left, right);
  const double mm_per_px = depth_mm(model, plane.along_sight * model.focal_px) / model.focal_px;
  const double shown_height = plane.shown_height();
  const Unyawed in_left = unyawed(left, front_slimness, shown_height);
  const Unyawed in_right = unyawed(right, front_slimness, shown_height);
  const double raw_px = unyawed(left, front_slimness).size_px + unyawed(right, front_slimness).size_px;
  const double larger_px = std::max(in_left.size_px, in_right.size_px);
  const double across = plane.across - plane.ahead * plane.x;
  const double by_across = across / plane.normal2() * plane.across_spread;
  const double by_down = (plane.down - plane.ahead * plane.y) / plane.normal2() * plane.down_spread;
  const double by_tilt = plane.down / plane.normal2() * plane.down_spread;
  const double ordinary = squared(length_spread) + squared(plane.across_spread) / 2;
  return {.area_mm2 = {view_from_front(model, plane, to_image_of(left)).area_mm2,
                       std::sqrt(2 * ordinary + squared(by_across) + squared(by_down))},
          .size_mm = {(in_left.size_px + in_right.size_px) / 2 * mm_per_px,
                      std::sqrt(ordinary + squared(in_left.spread) + squared(by_tilt))},
          .area_by_tilt = std::sqrt(plane.normal2()) / length(plane.across, plane.ahead + plane.down * plane.y),
          .size_by_tilt = (in_left.size_px + in_right.size_px) / raw_px,
          .tilt_deviations = plane.down / plane.down_spread,
          .contrast = (contrast_of(left) + contrast_of(right)) / 2,
          .left_shown = in_left.shown * in_left.size_px / larger_px,
          .right_shown = in_right.shown * in_right.size_px / larger_px,
          .disparity_px = plane.along_sight * model.focal_px};
}

Narrowed narrowed(double left_shown, double right_shown, const FaceSize& now, const SeenMark& left) {
  const double by_left = left_shown - now.left_shown;
  const double by_right = right_shown - now.right_shown;
  const double wide_px = left.width_px / now.left_shown;
  const double apart = motion_by_strip * std::abs(by_left - by_right) * wide_px;
  return {motion_by_strip * std::max(0.0, by_left) * wide_px, apart / now.disparity_px};
}

WholeFace::WholeFace(const FaceSize& size, const SeenMark& left)
    : recent_(size),
      largest_(size),
      largest_if_not_tilted_(if_not_tilted(size)),
      largest_at_(left.centre),
      recent_at_(left.centre) {}

FaceSize WholeFace::foreseen(const SeenMark& left) const {
  const double drifted = squared(drift) * cv::norm(left.centre - recent_at_) / left.box.width;
  FaceSize out = recent_;
  out.area_mm2.spread = std::sqrt(squared(out.area_mm2.spread) + 4 * drifted);
  out.size_mm.spread = std::sqrt(squared(out.size_mm.spread) + drifted);
  return out;
}

FaceSize WholeFace::compared(FaceSize now) const {
  const double lost = std::clamp(1 - now.contrast / recent_.contrast, 0.0, most_lost_contrast);
  now.area_mm2.spread = length(now.area_mm2.spread, 2 * narrowing * lost);
  now.size_mm.spread = length(now.size_mm.spread, narrowing * lost);
  return now;
}

// What covers a part makes neither larger.
bool WholeFace::is_more_than(const FaceSize& seen, const SeenMark& left) const {
  const FaceSize whole = foreseen(left);
  const FaceSize now = compared(seen);
  const auto [less, more] =
      std::minmax({deviations(whole.area_mm2, now.area_mm2), deviations(whole.size_mm, now.size_mm)});
  return less < -clear && more < likely;
}

double WholeFace::drifted(const SeenMark& left) const {
  const double widths = cv::norm(left.centre - largest_at_) / left.box.width;
  return std::min(most_drift, drift * std::sqrt(widths));
}

bool WholeFace::is_as_large(const FaceSize& now, const SeenMark& left, double most_off_px) const {
  const double missing_at_most =
      missing(largest_.area_mm2.value, now.area_mm2, -2 * drifted(left)) + 2 * now.area_mm2.spread;
  return off_if_missing_px(left, missing_at_most) <= most_off_px;
}

double WholeFace::off_if_covered_px(const FaceSize& seen, const SeenMark& left) const {
  const FaceSize now = if_not_tilted(seen);
  const double drifted = this->drifted(left);
  const double by_area = missing(largest_if_not_tilted_.area_mm2.value, now.area_mm2, 2 * drifted);
  const double by_height = missing(largest_if_not_tilted_.size_mm.value, now.size_mm, drifted);
  const Narrowed as_covered = narrowed(largest_.left_shown, largest_.right_shown, now, left);
  const FaceSize::Reading& height = recent_.size_mm.spread < now.size_mm.spread ? recent_.size_mm : now.size_mm;
  const double too_small = 1 - std::min(now.size_mm.value, height.value) / largest_if_not_tilted_.size_mm.value;
  const double beyond = (as_covered.too_small - too_small) / length(height.spread, drifted);
  const double plausible = std::clamp(clear - beyond, 0.0, 1.0);
  return std::max(off_if_missing_px(left, std::max(by_area, by_height)), plausible * as_covered.off_px);
}

void WholeFace::follow(const FaceSize& seen, const SeenMark& left) {
  const FaceSize before = foreseen(left);
  const FaceSize now = compared(seen);
  recent_at_ = left.centre;
  recent_ = {.area_mm2 = followed(before.area_mm2, now.area_mm2),
             .size_mm = followed(before.size_mm, now.size_mm),
             .area_by_tilt = now.area_by_tilt,
             .size_by_tilt = now.size_by_tilt,
             .tilt_deviations = now.tilt_deviations,
             .contrast = recent_.contrast + contrast_gain * (now.contrast - recent_.contrast),
             .left_shown = recent_.left_shown + shown_gain * (now.left_shown - recent_.left_shown),
             .right_shown = recent_.right_shown + shown_gain * (now.right_shown - recent_.right_shown),
             .disparity_px = now.disparity_px};
  if (recent_.left_shown > largest_.left_shown) {
    largest_.left_shown = recent_.left_shown;
    largest_.right_shown = recent_.right_shown;
  }
  const FaceSize flat = if_not_tilted(recent_);
  const auto larger = [](const FaceSize::Reading& a, const FaceSize::Reading& b) { return a.value < b.value ? b : a; };
  largest_if_not_tilted_.area_mm2 = larger(largest_if_not_tilted_.area_mm2, flat.area_mm2);
  largest_if_not_tilted_.size_mm = larger(largest_if_not_tilted_.size_mm, flat.size_mm);
  largest_.size_mm = larger(largest_.size_mm, recent_.size_mm);
  if (recent_.area_mm2.value < largest_.area_mm2.value) return;
  largest_.area_mm2 = recent_.area_mm2;
  largest_at_ = left.centre;
}

}  // namespace pizarra::vision
