#include "agents/vision/sight/whole_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/objects/recognise.hpp"
#include "agents/vision/sight/covered_part.hpp"

namespace pizarra {
namespace {

// What the light's slope and the blur make of a length, as a part of it.
constexpr double ordinary_spread = 0.003;
// What turning in the image makes of the height, as a part of what the mark lacks to be round.
constexpr double turning_share = 0.1;
// How far a length drifts, as a part of it, where the mark moves by its own width; farther by the root.
constexpr double drift = 0.0075;
// But no more anywhere; and how far what was learned elsewhere is off.
constexpr double most_drift = 0.02;
constexpr double learned_spread = 0.01;
// Where edges run along the pixels and fall between two, blur reaches into what is taken for ground: the contrast is
// less, and every length by so much of the part that is lost. What loses more is in another light.
constexpr double narrowing = 0.25;
constexpr double most_lost_contrast = 0.1;
// How much of a new contrast the memory takes over.
constexpr double contrast_gain = 0.1;
// And of a new aspect.
constexpr double aspect_gain = 0.3;
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

// What is left of a value that noise of this spread makes about 0.
double beyond_noise(double value, double spread) {
  return value == 0 ? 0 : value * std::max(0.0, 1 - squared(spread / value));
}

// Where it is covered rather than tilted.
FaceSize if_not_tilted(FaceSize size) {
  size.area_mm2.value /= size.area_by_tilt;
  size.height_mm.value /= size.height_by_tilt;
  return size;
}

// How much of `whole` is missing, where it may be off by `slack` besides.
double missing(double whole, const FaceSize::Reading& now, double slack) {
  return 1 - now.value / whole - now.spread - slack;
}

}  // namespace

// Of a plane 1 / Z is linear in the image, so the disparity is: d = d0 + a x + b y, and the plane's normal is
// (a, b, (d - a x - b y) / f), x and y from the principal point. The right image of a mark is the left one squeezed by
// 1 - a along x and sheared by -b; second moments say both. An image shows so much of the area as the line of sight
// has of the normal.
FaceSize face_size(const StereoModel& model, const SeenMark& left, const SeenMark& right, double front_slimness) {
  const double x = (left.centre.x - model.centre_x_px) / model.focal_px;
  const double y = (left.centre.y - model.centre_y_px) / model.focal_px;
  const double disparity_px = left.centre.x - right.centre.x;
  const double mm_per_px = depth_mm(model, disparity_px) / model.focal_px;
  const double along_sight = disparity_px / model.focal_px;
  const double spread = centre_spread_px(left, left.noise) / left.width_px;
  const double spread_of_both = std::numbers::sqrt2 * spread;
  const double area_px2 = spread_product_px2(left);
  const double squeezed = spread_product_px2(right) / right.height_px / (area_px2 / left.height_px);
  const double across = 1 - squeezed;
  const double sheared = (squeezed * left.slant_px2 - right.slant_px2) / (left.height_px * right.height_px);
  const double shear_spread = spread_of_both * left.width_px / left.height_px;
  const double down = beyond_noise(sheared, shear_spread);
  const double ahead = along_sight - across * x - down * y;
  const double normal2 = squared(across) + squared(down) + squared(ahead);
  // What the tilt makes of a length along y.
  const double tilt = down / along_sight;
  const double shown_height = 1 / std::sqrt(1 - 2 * tilt * y + squared(tilt) * (1 + squared(x) + squared(y)));
  const double by_across = (across - ahead * x) / normal2 * spread_of_both;
  const double by_down = (down - ahead * y) / normal2 * shear_spread;
  const double by_tilt = tilt * squared(shown_height) * shear_spread / along_sight;
  const double by_turning = turning_share * (1 - front_slimness);
  const double ordinary = squared(ordinary_spread) + squared(spread);
  const double height_px = std::max(left.height_px, right.height_px) / shown_height;
  return {.area_mm2 = {area_px2 * std::sqrt(normal2) / along_sight * squared(mm_per_px),
                       std::sqrt(2 * ordinary + squared(by_across) + squared(by_down))},
          .height_mm = {(left.height_px + right.height_px) / 2 / shown_height * mm_per_px,
                        std::sqrt(ordinary + squared(by_turning) + squared(by_tilt))},
          .area_by_tilt = std::sqrt(normal2) / length(across, along_sight - across * x),
          .height_by_tilt = 1 / shown_height,
          .contrast = (contrast_of(left) + contrast_of(right)) / 2,
          .left_aspect = left.width_px / height_px,
          .right_aspect = right.width_px / height_px,
          .disparity_px = disparity_px};
}

// What lies nearer than the mark and over one side of it hides more from one camera than from the other. So the mark
// looks turned; but both centres come apart as well, by half as much, so that it looks too near, and too small.
struct Narrowed {
  double off_px;     // how far the centre is off if it is covered
  double too_small;  // how much of its height is missing then
};

Narrowed narrowed(double left_aspect, double right_aspect, const FaceSize& now, const SeenMark& left) {
  const double by_left = left_aspect - now.left_aspect;
  const double by_right = right_aspect - now.right_aspect;
  const double apart = motion_by_strip * std::abs(by_left - by_right) * left.height_px;
  return {motion_by_strip * std::max(0.0, by_left) * left.height_px, apart / now.disparity_px};
}

double may_be_off_px(const LearnedObject& object, const FaceSize& seen, const SeenMark& left) {
  const FaceSize now = if_not_tilted(seen);
  double least_mm2 = 0;
  for (const LearnedSample& sample : object.samples) {
    // Of a size that is not known the form alone says something.
    if (sample.measured_size_mm() <= 0) return may_be_off_by_shape_px(left, front_slimness(object));
    // One that is slim may have been learned on its side, or turned away.
    const double area_mm2 = squared(sample.measured_size_mm()) * sample.slimness;
    least_mm2 = least_mm2 == 0 ? area_mm2 : std::min(least_mm2, area_mm2);
  }
  if (least_mm2 == 0) return 0;
  const double by_area = may_be_off_px(left, missing(least_mm2, now.area_mm2, 2 * learned_spread));
  const double front = front_slimness(object);
  const Narrowed as_covered = narrowed(front, front, now, left);
  const double too_small = 1 - now.height_mm.value / std::sqrt(least_mm2);
  const double spread = length(now.height_mm.spread, learned_spread);
  const double ahead = (squared(too_small) - squared(too_small - as_covered.too_small)) / (2 * squared(spread));
  return std::max(by_area, std::clamp(ahead, 0.0, 1.0) * as_covered.off_px);
}

WholeFace::WholeFace(const FaceSize& size, const SeenMark& left)
    : recent_(size), largest_(size), largest_at_(left.centre), recent_at_(left.centre) {}

FaceSize WholeFace::foreseen(const SeenMark& left) const {
  const double drifted = squared(drift) * cv::norm(left.centre - recent_at_) / left.box.width;
  FaceSize out = recent_;
  out.area_mm2.spread = std::sqrt(squared(out.area_mm2.spread) + 4 * drifted);
  out.height_mm.spread = std::sqrt(squared(out.height_mm.spread) + drifted);
  return out;
}

FaceSize WholeFace::compared(FaceSize now) const {
  const double lost = std::clamp(1 - now.contrast / recent_.contrast, 0.0, most_lost_contrast);
  now.area_mm2.spread = length(now.area_mm2.spread, 2 * narrowing * lost);
  now.height_mm.spread = length(now.height_mm.spread, narrowing * lost);
  return now;
}

// What covers a part makes neither larger.
bool WholeFace::is_more_than(const FaceSize& seen, const SeenMark& left) const {
  const FaceSize whole = foreseen(left);
  const FaceSize now = compared(seen);
  const auto [less, more] =
      std::minmax({deviations(whole.area_mm2, now.area_mm2), deviations(whole.height_mm, now.height_mm)});
  return less < -clear && more < likely;
}

double WholeFace::drifted(const SeenMark& left) const {
  const double widths = cv::norm(left.centre - largest_at_) / left.box.width;
  return std::min(most_drift, drift * std::sqrt(widths));
}

bool WholeFace::is_as_large(const FaceSize& now, const SeenMark& left, double most_off_px) const {
  const double missing_at_most = missing(largest_.area_mm2.value, now.area_mm2, -2 * drifted(left)) +
                                 2 * now.area_mm2.spread;
  return pizarra::may_be_off_px(left, missing_at_most) <= most_off_px;
}

double WholeFace::may_be_off_px(const FaceSize& seen, const SeenMark& left) const {
  const FaceSize now = if_not_tilted(seen);
  const double drifted = this->drifted(left);
  const double by_area = missing(largest_.area_mm2.value, now.area_mm2, 2 * drifted);
  const double by_height = missing(largest_.height_mm.value, now.height_mm, drifted);
  const Narrowed as_covered = narrowed(largest_.left_aspect, largest_.right_aspect, now, left);
  const FaceSize::Reading& height = recent_.height_mm.spread < now.height_mm.spread ? recent_.height_mm : now.height_mm;
  const double too_small = 1 - std::min(now.height_mm.value, height.value) / largest_.height_mm.value;
  const double beyond = (as_covered.too_small - too_small) / length(height.spread, drifted);
  const double plausible = std::clamp(clear - beyond, 0.0, 1.0);
  return std::max(pizarra::may_be_off_px(left, std::max(by_area, by_height)), plausible * as_covered.off_px);
}

void WholeFace::follow(const FaceSize& seen, const SeenMark& left) {
  const FaceSize before = foreseen(left);
  const FaceSize now = compared(seen);
  recent_at_ = left.centre;
  recent_ = {.area_mm2 = followed(before.area_mm2, now.area_mm2),
             .height_mm = followed(before.height_mm, now.height_mm),
             .area_by_tilt = now.area_by_tilt,
             .height_by_tilt = now.height_by_tilt,
             .contrast = recent_.contrast + contrast_gain * (now.contrast - recent_.contrast),
             .left_aspect = recent_.left_aspect + aspect_gain * (now.left_aspect - recent_.left_aspect),
             .right_aspect = recent_.right_aspect + aspect_gain * (now.right_aspect - recent_.right_aspect),
             .disparity_px = now.disparity_px};
  if (recent_.left_aspect > largest_.left_aspect) {
    largest_.left_aspect = recent_.left_aspect;
    largest_.right_aspect = recent_.right_aspect;
  }
  largest_.height_mm = std::ranges::max(largest_.height_mm, recent_.height_mm, {}, &FaceSize::Reading::value);
  if (recent_.area_mm2.value < largest_.area_mm2.value) return;
  largest_.area_mm2 = recent_.area_mm2;
  largest_at_ = left.centre;
}

}  // namespace pizarra
