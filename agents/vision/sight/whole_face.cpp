#include "agents/vision/sight/whole_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pizarra {
namespace {

// What the light's slope and the blur make of a length, as a part of it.
constexpr double ordinary_spread = 0.003;
// What turning in the image makes of the height, as a part of what the mark lacks to be round.
constexpr double turning_share = 0.1;
// How far a length drifts, as a part of it, where the mark moves by its own width; farther by the root.
constexpr double drift = 0.0075;
// Where edges run along the pixels and fall between two, blur reaches into what is taken for ground: the contrast is
// less, and every length by so much of the part that is lost. What loses more is in another light.
constexpr double narrowing = 0.25;
constexpr double most_lost_contrast = 0.1;
// How much of a new contrast the memory takes over.
constexpr double contrast_gain = 0.1;
// In standard deviations: what noise makes, and what it hardly makes.
constexpr double likely = 2;
constexpr double clear = 3;

double squared(double x) { return x * x; }

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

// Of a face of yaw p an image shows cos(p) - t sin(p), at slope t off the axis; face_yaw_deg() says p.
FaceSize face_size(const StereoModel& model, const SeenMark& left, const SeenMark& right, double front_slimness) {
  const double left_slope = (left.centre.x - model.centre_x_px) / model.focal_px;
  const double right_slope = (right.centre.x - model.centre_x_px) / model.focal_px;
  const double mm_per_px = depth_mm(model, left.centre.x - right.centre.x) / model.focal_px;
  const double tangent = (right.width_px - left.width_px) / (left_slope * right.width_px - right_slope * left.width_px);
  const double cosine = 1 / std::sqrt(1 + squared(tangent));
  const double shown = (1 - left_slope * tangent) * cosine;
  const double area_px2 = std::sqrt(squared(left.width_px * left.height_px) - squared(left.slant_px2));
  const double spread = centre_spread_px(left, left.noise) / left.width_px;
  // How far the yaw may be off, radians, and what that makes of the area.
  const double yaw_spread = std::numbers::sqrt2 * spread * squared(cosine) / (left_slope - right_slope);
  const double by_yaw = (tangent + left_slope) * cosine / shown * yaw_spread;
  const double by_turning = turning_share * (1 - front_slimness);
  const double ordinary = squared(ordinary_spread) + squared(spread);
  return {.area_mm2 = {area_px2 / shown * squared(mm_per_px), std::sqrt(2 * ordinary + squared(by_yaw))},
          .height_mm = {(left.height_px + right.height_px) / 2 * mm_per_px,
                        std::sqrt(ordinary + squared(by_turning))},
          .contrast = (contrast_of(left) + contrast_of(right)) / 2};
}

WholeFace::WholeFace(const FaceSize& size, const SeenMark& left) : size_(size), place_(left.centre) {}

FaceSize WholeFace::foreseen(const SeenMark& left) const {
  const double drifted = squared(drift) * cv::norm(left.centre - place_) / left.box.width;
  FaceSize out = size_;
  out.area_mm2.spread = std::sqrt(squared(out.area_mm2.spread) + 4 * drifted);
  out.height_mm.spread = std::sqrt(squared(out.height_mm.spread) + drifted);
  return out;
}

FaceSize WholeFace::compared(FaceSize now) const {
  const double lost = std::clamp(1 - now.contrast / size_.contrast, 0.0, most_lost_contrast);
  now.area_mm2.spread = std::hypot(now.area_mm2.spread, 2 * narrowing * lost);
  now.height_mm.spread = std::hypot(now.height_mm.spread, narrowing * lost);
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

void WholeFace::follow(const FaceSize& seen, const SeenMark& left) {
  const FaceSize whole = foreseen(left);
  const FaceSize now = compared(seen);
  size_ = {.area_mm2 = followed(whole.area_mm2, now.area_mm2),
           .height_mm = followed(whole.height_mm, now.height_mm),
           .contrast = whole.contrast + contrast_gain * (now.contrast - whole.contrast)};
  place_ = left.centre;
}

}  // namespace pizarra
