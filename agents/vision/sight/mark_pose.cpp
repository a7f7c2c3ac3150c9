#include "agents/vision/sight/mark_pose.hpp"

#include <cmath>

#include "agents/vision/sight/seen_range.hpp"
#include "agents/vision/sight/tag_pose.hpp"

namespace pizarra::vision {
namespace {

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

std::optional<MarkPose> pose_of_tag(const camera::StereoModel& model, const LearnedObject& object,
                                    const SeenMark& tag) {
  for (const LearnedSample& sample : object.samples) {
    if (sample.face_mm() <= 0) continue;
    const std::optional<TagPose> pose = tag_pose(model, tag.corners, side_of_square(sample.face_mm()));
    if (pose) return MarkPose{pose->middle_mm, pose->turn, pose->covariance};
  }
  return std::nullopt;
}

}  // namespace

std::optional<MarkPose> pose_of(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& pair,
                                const std::optional<SeenRange>& range) {
  std::optional<MarkPose> out;
  if (pair.left.tag) out = pose_of_tag(model, object, pair.left);
  if (!pair.left.tag && pair.plane && pair.plane->pose) {
    out = MarkPose{pair.plane->pose->place_mm, pair.plane->pose->turn, pair.plane->pose->covariance};
  }
  if (!out) return std::nullopt;
  out->place_mm[0] -= model.base_line_mm / 2;
  if (range) move_to(*out, *range);
  return out;
}

}  // namespace pizarra::vision
