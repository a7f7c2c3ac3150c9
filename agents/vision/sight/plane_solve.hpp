#pragma once

// Where a plane is in space, by points of it that one image shows, or both of a pair: Gauss-Newton steps on six
// numbers, the plane's form and what pulls edges, from both tilts that a look without perspective allows.
//
//   const std::vector<PlaneGuess> both = plane_guesses(model, middle, px_a_mm);
//   const std::vector<SolvedPlane> poses = solve_plane(points, both, {.weight = 40});     // the likelier one first
//
// (D. Oberkampf, D. F. DeMenthon, L. S. Davis, Iterative pose estimation using coplanar feature points, 1996.) The
// inverse of the normal matrix is the covariance (JCGM 100:2008, 6.2). The points of a side may share an error, which
// no scatter shows. Its covariance is added.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

// A point of the plane. The image says where it is along one direction only, `normal`.
struct PlanePoint {
  Eigen::Vector2d plane;   // mm
  Eigen::Vector2d seen;    // slopes off the camera's axis
  Eigen::Vector2d normal;  // times the focal length, so that an error along it is in px
  double beside_mm = 0;    // how far to the right of the left camera the one stands that sees it
  double pulled = 0;       // 1 or -1 where a clipped edge pulls it, along the normal or against it
  std::size_t side = 0;    // of the plane's border: what is pulled on one side, by one camera, is pulled alike
};

struct PlaneGuess {
  Eigen::Matrix3d turn;   // the plane's axes, as the camera's
  Eigen::Vector3d place;  // of the plane's origin, mm
  // How many times larger than said the plane is; by how much more it reaches along x, and less along y; and along one
  // diagonal, and less along the other.
  Eigen::Vector3d form = {1, 0, 0};
  double pull_px = 0;  // how far what is pulled lies off
};

struct SolvedPlane {
  PlaneGuess pose;
  Eigen::Matrix<double, 6, 6> covariance;  // of the place, mm, then of a small turn about the camera's axes, rad
  double misfit;                           // half of the squared deviations
};

struct PlaneErrors {
  double weight;  // the inverse variance of a point, px
  // Of the form: what is nearly zero is known.
  double size_spread = 1e-6;
  double stretch_spread = 1e-6;
  // Of the pull, in all; and how far that of one side may differ, px.
  double usual_pull_px = 0;
  double pull_spread_px = 1e-6;
  double side_spread_px = 0;
};

// The image shows the plane's axes shortened. The rest of their length is depth, towards the camera or away from it,
// which makes two guesses. `slope`: px a mm at `middle`. None if no plane looks like that.
std::vector<PlaneGuess> plane_guesses(const camera::StereoModel& model, cv::Point2d middle, const cv::Matx22d& slope);

std::vector<SolvedPlane> solve_plane(std::span<const PlanePoint> points, std::span<const PlaneGuess> guesses,
                                     const PlaneErrors& errors);

// How the plane's origin moves where the points of a side are left out, and how sure its place is then, mm.
struct PlaneMove {
  Eigen::Vector3d by;
  Eigen::Matrix3d covariance;
};
// For each side, from the pose that all points say: one Gauss-Newton step. Points without a side are left out as well.
std::vector<PlaneMove> moves_without_sides(std::span<const PlanePoint> points, const PlaneGuess& pose,
                                           const PlaneErrors& errors);

// How far the point is seen from where the pose puts it, along its normal, px.
double off_px(const PlanePoint& point, const PlaneGuess& pose);

cv::Matx33d matx_of(const Eigen::Matrix3d& turn);

}  // namespace pizarra::vision
