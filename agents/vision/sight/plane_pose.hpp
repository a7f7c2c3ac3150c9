#pragma once

// Where the plane of a mark is in space, and whether what looks tilted may be covered instead. It is found by the edges
// that registered the outline (plane_fit.hpp), in one image or in both of a pair together.
//
//   const std::optional<PlanePose> pose = plane_pose(model, sample.plane, fit, {.unit_mm = sample.face_mm()});
//   pose->place_mm, pose->turn, pose->covariance
//   const double covered = covered_rather_than_tilted(*pose, 6);   // 0 to 1
//
// Six numbers, by how far the edges are off along their normals (plane_solve.hpp), with how far the edges themselves
// scatter.

#include <Eigen/Core>
#include <optional>

#include "agents/vision/marks/plane_fit.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

struct PlaneTilt {
  cv::Vec3d place_mm;                      // of the mark's centroid: from the camera, x right, y down, z along its axis
  cv::Matx33d turn;                        // the mark's axes: right, down and away from who sees it from the front
  Eigen::Matrix<double, 6, 6> covariance;  // of the place, mm, then of the turn about the camera's axes, rad
  double misfit = 0;                       // how badly it explains the edges: half of the squared deviations
  // How far off the centroid may be in the left image, if what hides one of the mark's sides was taken for that side:
  // the most by any side, a root mean square.
  double off_if_hidden_px = 0;
};

struct PlanePose : PlaneTilt {
  PlaneTilt other;       // the other tilt that looks nearly alike
  bool by_both = false;  // of a pair's images
  // How badly these explain the edges.
  double affine_misfit = 0;  // a look without perspective, as of what is covered and faces the camera
  double free_misfit = 0;    // any homography

  // How likely the other tilt is it, 0 to 1: by the edges, and before one camera by how unusual either is.
  double share_of_other() const;
  bool is_contradicted() const;          // another homography explains the edges far better
  double odds_of_no_plane() const;       // how many times likelier no plane, or another form, is than this pose
  bool shows_perspective() const;        // it explains them far better than an affine map
  double most_off_if_hidden_px() const;  // by either tilt, where both may be it
};

struct PlaneFace {
  double unit_mm;                            // how long a standard deviation of the mark is
  cv::Matx22d stretch = cv::Matx22d::eye();  // of the outline, as it is from the front (LearnedSample::stretch())
  double stretch_spread = 0;                 // how far that may be off along either axis: a standard deviation
  // How it was turned in the frame before, where both images of a pair registered it: where to begin.
  std::optional<cv::Matx33d> turned_before = {};
};

// Nothing where the edges are no plane's in front of it. `right`: in the right image, where that shows it; then the
// size is only about known, and a look without perspective is not weighed.
std::optional<PlanePose> plane_pose(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& left,
                                    const PlaneFace& face, const PlaneFit* right = nullptr);

// Half of the squared deviation of how far a face is turned from the axis of a camera, which is aimed at what it is to
// see.
double unusual(const PlaneTilt& tilt);

// How usual it is that a face is turned so far from the axis of a camera, which is aimed at what it is to see: 1 where
// it faces the camera. By both tilts, as the edges explain them.
double usual_turn(const PlanePose& pose);

// Where the mark's middle is seen, px: by both tilts, as likely as each is, and no farther than that from either while
// both may be it. Of two that explain the edges alike the more usual one is the likelier.
cv::Point2d middle_in_image(const camera::StereoModel& model, const PlanePose& pose, double most_off_px);

// How likely a look that is slimmer than the mark is one of a part of it, facing the camera, rather than of all of it,
// tilted: perspective goes with a tilt. `tilted_for_one_covered`: where that says nothing.
double covered_rather_than_tilted(const PlanePose& pose, double tilted_for_one_covered);

// How far off the centre may be where a part beyond a straight edge is hidden that the fit took up, px: that leaves
// edges that are off together, side by side, where noise leaves each off by itself. The template leaves them off
// together where it rounds corners; there it says nothing.
double off_if_bent_px(const PlaneOutline& outline, const PlaneFit& fit);

}  // namespace pizarra::vision
