#include "agents/vision/sight/mark_pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/sight/seen_range.hpp"
#include "agents/vision/sight/tag_pose.hpp"

namespace pizarra::vision {
namespace {

// Less likely, and less turned, another tilt need not be told.
constexpr double least_share = 0.01;
constexpr double least_apart = 0.05;  // rad
constexpr double degrees_a_rad = 180 / std::numbers::pi;

// The same where the range is known better.
void move_to(MarkPose& pose, const SeenRange& range) {
  const double seen_mm = cv::norm(pose.place_mm);
  const Eigen::Vector3d sight = Eigen::Vector3d(pose.place_mm[0], pose.place_mm[1], pose.place_mm[2]) / seen_mm;
  pose.place_mm *= range.mm / seen_mm;
  Eigen::Matrix<double, 6, 6> beside = Eigen::Matrix<double, 6, 6>::Identity();
  beside.topLeftCorner<3, 3>() -= sight * sight.transpose();
  pose.covariance = beside * pose.covariance * beside.transpose();
  pose.covariance.topLeftCorner<3, 3>() += range.spread_mm * range.spread_mm * sight * sight.transpose();
}

std::optional<MarkPose::Flipped> flipped_of(const cv::Matx33d& turn, const cv::Matx33d& other, double share) {
  const cv::Matx33d apart = turn - other;
  const bool is_another = std::hypot(apart(0, 2), apart(1, 2), apart(2, 2)) > least_apart;
  return is_another && share > least_share ? std::optional(MarkPose::Flipped{other, share}) : std::nullopt;
}

std::optional<MarkPose> pose_of_tag(const camera::StereoModel& model, const LearnedObject& object,
                                    const SeenPair& tag) {
  const SquareCorners* right = tag.right ? &tag.right->corners : nullptr;
  for (const LearnedSample& sample : object.samples) {
    if (sample.face_mm() <= 0) continue;
    const std::optional<TagPose> pose = tag_pose(model, tag.left.corners, side_of_square(sample.face_mm()), right);
    if (!pose) continue;
    return MarkPose{pose->middle_mm, pose->turn, pose->covariance,
                    flipped_of(pose->turn, pose->other_turn, pose->share_of_other)};
  }
  return std::nullopt;
}

// From the middle of the base line.
MarkPose at_base(MarkPose pose, const camera::StereoModel& model, const std::optional<SeenRange>& range) {
  pose.place_mm[0] -= model.base_line_mm / 2;
  if (range) move_to(pose, *range);
  return pose;
}

}  // namespace

MarkPose pose_of(const camera::StereoModel& model, const PlanePose& plane, const std::optional<SeenRange>& range) {
  MarkPose out{plane.place_mm, plane.turn, plane.covariance,
               flipped_of(plane.turn, plane.other.turn, plane.share_of_other())};
  if (out.flipped) {
    // Its middle is elsewhere then.
    const cv::Vec3d apart = plane.other.place_mm - plane.place_mm;
    const Eigen::Vector3d by(apart[0], apart[1], apart[2]);
    out.covariance.topLeftCorner<3, 3>() += out.flipped->share * by * by.transpose();
  }
  return at_base(out, model, range);
}

std::optional<MarkPose> pose_of(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& pair,
                                const std::optional<SeenRange>& range) {
  if (!pair.left.tag) {
    return pair.plane && pair.plane->pose ? std::optional(pose_of(model, *pair.plane->pose, range)) : std::nullopt;
  }
  const std::optional<MarkPose> tag = pose_of_tag(model, object, pair);
  return tag ? std::optional(at_base(*tag, model, range)) : std::nullopt;
}

cv::Vec3d angles_deg(const cv::Matx33d& r) {
  return degrees_a_rad * cv::Vec3d(std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
                                   std::atan2(r(1, 0), r(0, 0)));
}

std::array<double, 6> spreads_of(const MarkPose& pose) {
  std::array<double, 6> out{};
  for (int i = 0; i < 6; ++i) {
    out[static_cast<std::size_t>(i)] = std::sqrt(pose.covariance(i, i)) * (i < 3 ? 1 : degrees_a_rad);
  }
  return out;
}

}  // namespace pizarra::vision
