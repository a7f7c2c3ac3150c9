#include "agents/vision/sight/seen_range.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/face_plane.hpp"
#include "agents/vision/sight/tag_pose.hpp"
#include "agents/vision/sight/unyawed.hpp"

namespace pizarra::vision {
namespace {

// How far a range by size may be off, as a part of it: a standard deviation.
constexpr double spread_by_size = 0.01;
// Of the disparity, px, by the pixels' phase: of any mark, of a tag, and of a large mark with its edges along the
// pixels.
constexpr double ordinary_phase_px = 0.018;
constexpr double tag_phase_px = 0.04;
constexpr double edge_phase_px = 0.28;
// Few whole marks that face the cameras are taken for whole with less confidence; then the disparity is off at least by
// that, px.
constexpr double clearly_whole = 0.97;
constexpr double least_covered_px = 0.2;
// The correlation of the errors of a pair's two ranges, by centroids and by edges: measured, 0.1 to 0.4.
constexpr double in_common_of_ranges = 0.25;

double square(double x) { return x * x; }

// Of the motion of the mark's centre along x, for each px that all its edges along y would move: those of which each
// lies between the same two columns of pixels, for only their phases do not cancel.
double moved_by_upright_edges(const SeenMark& mark) {
  const MarkContour& contour = mark.contour;
  double squares = 0;
  int begun_at = contour.back().x;
  int length = 0;
  const auto end_edge = [&] { squares += square(length * (begun_at - mark.centre.x)); };
  for (const cv::Point& p : contour) {
    if (p.x != begun_at) {
      end_edge();
      begun_at = p.x;
      length = 0;
    }
    ++length;
  }
  end_edge();
  return std::sqrt(squares) / mark.area_px;
}

// Measured over circles, squares, crosses and triangles, 12 to 190 px wide, blurred by up to 1.5 px. Light is divided
// out of large marks edge by edge, and where an edge falls between pixels says how dark the ground beside it looks;
// along an edge that is turned by a few degrees phases cancel.
double disparity_by_phase_px(const SeenMark& left) {
  if (left.tag) return tag_phase_px;
  if (!is_large_mark(left.box)) return ordinary_phase_px;
  return std::hypot(ordinary_phase_px, edge_phase_px * square(moved_by_upright_edges(left)));
}

double disparity_if_covered_px(const SeenMark& left, const SeenMark& right) {
  return std::hypot(least_covered_px, motion_by_strip * (left.width_px - right.width_px));
}

// A tilted face, its centroid at P, and Z along the optical axis. A piece that is nearer by a part e is larger by 3 e
// in either image, and its disparity is 1 + e times as large. To second order both centroids are those of a point off
// by -4 Cov(P, Z) / Z, over the mark. The disparity's slopes along the mark, which the plane says, say Cov(P, Z).
struct TiltError {
  double mm;
  double part_spread;  // of the range
};

TiltError error_by_tilt(const camera::StereoModel& model, const SeenMark& left, const FacePlane& plane, double range) {
  const double depth = model.base_line_mm / plane.along_sight;
  const double disparity = plane.along_sight * model.focal_px;
  const double xx = square(left.width_px);
  const double with_x = plane.across * xx + plane.down * left.slant_px2;
  const double with_y = plane.across * left.slant_px2 + plane.down * square(left.height_px);
  const double by_noise = square(plane.across_spread) * xx;
  const double of_depth = std::max(0.0, plane.across * with_x + plane.down * with_y - by_noise) / square(disparity);
  const double sight_x = (plane.x * depth - model.base_line_mm / 2) / range;
  const double sight_y = plane.y * depth / range;
  const double sight_z = depth / range;
  const double along = of_depth * (plane.x * sight_x + plane.y * sight_y + sight_z);
  const double beside = (sight_x * with_x + sight_y * with_y) / (model.focal_px * disparity);
  const double noise = by_noise / square(disparity);
  return {-4 * depth * (along - beside), 4 * (2 * std::sqrt(of_depth * noise) + noise)};
}

std::optional<SeenRange> range_of_tag(const camera::StereoModel& model, double face_mm, const SeenMark& left) {
  const std::optional<TagPose> pose = tag_pose(model, left.corners, side_of_square(face_mm));
  if (!pose) return std::nullopt;
  return SeenRange{pose->range_mm, std::hypot(spread_by_size * pose->range_mm, pose->range_spread_mm)};
}

SeenRange range_of_pose(const camera::StereoModel& model, const PlanePose& pose) {
  const auto from_base = [&](const cv::Vec3d& place_mm) {
    return Eigen::Vector3d(place_mm[0] - model.base_line_mm / 2, place_mm[1], place_mm[2]);
  };
  const Eigen::Vector3d place = from_base(pose.place_mm);
  const double range = place.norm();
  const Eigen::Vector3d sight = place / range;
  // In the other tilt it is elsewhere.
  const double apart = from_base(pose.other.place_mm).norm() - range;
  const double variance =
      sight.dot(pose.covariance.topLeftCorner<3, 3>() * sight) + pose.share_of_other() * square(apart);
  return {range, std::hypot(pose.by_both ? 0 : spread_by_size * range, std::sqrt(variance))};
}

// The larger principal standard deviation of a mark, px, if its face were parallel to the image. Beside the middle of
// the image a face that looks at the camera is longer away from the middle than one that is parallel to the image.
double longer_axis_px(const camera::StereoModel& model, const SeenMark& left) {
  const Eigen::Vector2d sight((left.centre.x - model.centre_x_px) / model.focal_px,
                              (left.centre.y - model.centre_y_px) / model.focal_px);
  Eigen::Matrix2d spread;
  spread << square(left.width_px), left.slant_px2, left.slant_px2, square(left.height_px);
  spread -= sight * (sight.transpose() * spread) / (1 + sight.squaredNorm());
  const double half_trace = spread.trace() / 2;
  return std::sqrt(half_trace + std::sqrt(std::max(0.0, square(half_trace) - spread.determinant())));
}

// A mark that is as high as it is wide is foreshortened along one line alone. So its longer axis is the size of its
// face, however it is tilted, up to what its axes differ by from the front: which of them is shortened is not known.
std::optional<SeenRange> range_of_round(const camera::StereoModel& model, double face_mm, double front_slimness,
                                        const SeenMark& left) {
  const double longer_px = longer_axis_px(model, left);
  if (longer_px <= 0) return std::nullopt;
  const double mm = range_at_depth_mm(model, left.centre, model.focal_px * face_mm / longer_px);
  return SeenRange{mm, std::hypot(spread_by_size, std::log(front_slimness) / std::sqrt(12)) * mm};
}

// Of one that is slim only a yaw is known.
std::optional<SeenRange> range_of_slim(const camera::StereoModel& model, double face_mm, double front_slimness,
                                       const SeenMark& left) {
  const Unyawed look = unyawed(left, front_slimness);
  if (look.size_px <= 0) return std::nullopt;
  const double mm = range_at_depth_mm(model, left.centre, model.focal_px * face_mm / look.size_px);
  return SeenRange{mm, std::hypot(spread_by_size, look.spread) * mm};
}

SeenRange range_by_centres(const StereoSight& sight, const SeenMark& left, const SeenMark& right) {
  const camera::StereoModel& model = sight.model();
  const double disparity = left.centre.x - right.centre.x;
  const double range = range_mm(model, left.centre, disparity);
  const double variance_px2 = square(centre_noise_px(left, sight.noise())) +
                              square(centre_noise_px(right, sight.noise())) + square(disparity_by_phase_px(left));
  const TiltError tilt = error_by_tilt(model, left, face_plane(model, left, right), range);
  return {range - tilt.mm, range * std::sqrt(variance_px2 / square(disparity) + square(tilt.part_spread))};
}

// By inverse variances. The edge of a shadow moves the mark's centroids, in one image more than in the other, and no
// spread shows that. The mark's edges stay where they are. What the two ranges differ by beyond noise is added to the
// spread of the centroids'. Times the weight that this one keeps, it is added to the mean's spread too.
SeenRange mean_of(const SeenRange& by_centres, const SeenRange& by_edges) {
  const double noise = square(by_centres.spread_mm) + square(by_edges.spread_mm);
  const double unexplained = std::max(0.0, square(by_centres.mm - by_edges.mm) - noise);
  const double share = square(by_edges.spread_mm) / (noise + unexplained);
  const double of_centres = share * by_centres.spread_mm;
  const double of_edges = (1 - share) * by_edges.spread_mm;
  return {share * by_centres.mm + (1 - share) * by_edges.mm,
          std::sqrt(square(of_centres) + square(of_edges) + 2 * in_common_of_ranges * of_centres * of_edges +
                    share * unexplained)};
}

}  // namespace

SeenRange range_by_pair(const StereoSight& sight, const SeenPair& pair, double confidence_in_whole,
                        const PlanePose* lies) {
  const camera::StereoModel& model = sight.model();
  const SeenMark& left = pair.left;
  const SeenMark& right = *pair.right;
  const SeenRange by_centres = range_by_centres(sight, left, right);
  SeenRange out = by_centres;
  if (lies != nullptr) {
    const SeenRange by_edges = range_of_pose(model, *lies);
    out = pair.right_by_outline ? by_edges : mean_of(by_centres, by_edges);
  }
  double variance_px2 = square(model.deviations.disparity_px);
  // A cover's edge is taken for the mark's own: it moves the centroids, and the plane as well.
  if (confidence_in_whole < clearly_whole) variance_px2 += square(disparity_if_covered_px(left, right));
  const double part = std::sqrt(variance_px2 / square(left.centre.x - right.centre.x) +
                                square(model.deviations.focal_px / model.focal_px) +
                                square(model.deviations.base_line_mm / model.base_line_mm));
  return {out.mm, std::hypot(out.spread_mm, part * out.mm)};
}

std::optional<SeenRange> range_by_size(const camera::StereoModel& model, const LearnedObject& object,
                                       const SeenMark& left, const PlanePose* lies) {
  const auto size_of = [&](const LearnedSample& s) { return model.is_single() ? s.face_mm() : s.measured_face_mm(); };
  const auto sized = std::ranges::find_if(object.samples, [&](const LearnedSample& s) { return size_of(s) > 0; });
  if (sized == object.samples.end()) return std::nullopt;
  if (left.tag) return range_of_tag(model, size_of(*sized), left);
  if (lies != nullptr) return range_of_pose(model, *lies);
  const double slimness = front_slimness(object);
  if (slimness >= least_round) return range_of_round(model, size_of(*sized), slimness, left);
  return range_of_slim(model, size_of(*sized), slimness, left);
}

std::optional<SeenRange> range_of(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair,
                                  double confidence) {
  const PlanePose* lies = pair.plane && pair.plane->pose ? &*pair.plane->pose : nullptr;
  if (!pair.right) return range_by_size(sight.model(), object, pair.left, lies);
  const double in_whole = confidence_in_whole(confidence, pair.left.tag ? 1 : pair.likeness.confidence_if_covered());
  return range_by_pair(sight, pair, in_whole, lies != nullptr && lies->by_both ? lies : nullptr);
}

}  // namespace pizarra::vision
