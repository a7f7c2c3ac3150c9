#pragma once

// The coordinator's knowledge of the camera: where it stands relative to the arm (configuration), how it projects (the
// camera-model fact), and, on a pan-tilt unit, how that has turned it (the head fact). It says where in its images a
// point of the arm's base frame is seen, and gives the numbers by which a look is placed
// (lisp/modules/pizarra/looks.scm).
//
//   CameraView view(pose, model, {.pan_deg = 8, .tilt_deg = -2});
//   Sight sight = view.sight({450, -100, 30});

#include <Eigen/Core>
#include <array>

#include "drivers/ptu/head_axes.hpp"
#include "lisp/result.hpp"

namespace pizarra::coordinator {

// As in (camera-model EYES WIDTH HEIGHT FOCAL CX CY BASE-LINE): px, mm.
struct CameraModel {
  double width_px = 320;
  double height_px = 240;
  double focal_px = 431;
  double centre_x_px = 159.5;
  double centre_y_px = 119.5;
  double base_line_mm = 90;
};

Result<CameraModel> camera_model_from_fact(const Datum& fact);

using ptu::HeadTurn;

// A point as the left camera sees it: pixels, the range from the base line's centre, the depth along the axis.
struct Sight {
  double x_px;
  double y_px;
  double range_mm;
  double depth_mm;
};

class CameraView {
 public:
  CameraView(const forms::CameraPose& pose, const CameraModel& model, HeadTurn head = {});

  // As forms::LookSituation has its camera.
  Datum numbers() const;
  // The point must be before the camera.
  Sight sight(const Eigen::Vector3d& point) const;

  // A point of the base frame as the camera has it: across, down and ahead of its base line's centre; and back.
  Eigen::Vector3d to_camera(const Eigen::Vector3d& point) const;
  Eigen::Vector3d from_camera(const Eigen::Vector3d& seen) const;

  // Whether both images show all within `around_mm` of the point.
  bool shows(const Eigen::Vector3d& point, double around_mm) const;

  // Where the left and the right image are taken from.
  std::array<Eigen::Vector3d, 2> eyes() const;

  // Horizontal unit vectors: to the right in the image, and away from the camera, while its head is in the middle.
  const Eigen::Vector3d& right() const { return right_; }
  const Eigen::Vector3d& away() const { return away_; }
  const CameraModel& model() const { return model_; }
  double focal_px() const { return model_.focal_px; }
  double base_line_mm() const { return model_.base_line_mm; }

 private:
  CameraModel model_;
  Eigen::Vector3d centre_;
  Eigen::Vector3d right_;
  Eigen::Vector3d away_;
  // The image's axes.
  Eigen::Vector3d across_;
  Eigen::Vector3d down_;
  Eigen::Vector3d forward_;
};

}  // namespace pizarra::coordinator
