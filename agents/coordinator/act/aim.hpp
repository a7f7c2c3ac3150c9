#pragma once

// A target of a micro-task (plan/primitives.hpp) as geometry: which mark is followed and where it is to be. Looked up
// anew at every look, so that what moves is followed.

#include "agents/coordinator/act/spot_choice.hpp"
#include "agents/coordinator/geometry/servo.hpp"

namespace pizarra::coordinator {

struct Aim {
  Eigen::Vector3d followed_mm;  // where the mark is: the end effector's, or that of the held object
  Eigen::Vector3d wanted_mm;    // where it is to be
  double grip_height_mm;        // where the gripper is
  Eigen::Vector3d foot_mm;      // the point of the table about which the arm turns
};

class Aims {
 public:
  Aims(const CoordinatorOptions& options, const TaskDomain& domain, const Scene& scene)
      : options_(options), domain_(domain), scene_(scene), spots_(options, domain, scene) {}

  // A new operation: a free spot is chosen anew. One that is (free-spot HELD X Y) leaves in sight what stands behind
  // there.
  void reset() {
    spot_.reset();
    held_off_mm_.setZero();
  }
  // Failures: unseen (with the mark that is), no-room, unknown-place, bad-target.
  Result<Aim> at(const Datum& target);
  // The least height of the grip at which a cube in it passes over all that stands.
  double clear_height_mm() const;
  // How far the gripper may open around an object, mm.
  double opening_around(std::string_view object, double wide_mm) const;

 private:
  Result<Eigen::Vector3d> seen(std::string_view name) const;
  Result<Eigen::Vector3d> grip() const;
  double held_edge_mm(std::string_view held) const;
  Result<Eigen::Vector3d> on_top_of(std::string_view lower, std::string_view held) const;
  Result<Eigen::Vector3d> free_spot_for(const Datum& target);
  Eigen::Vector3d held_place(const std::string& held, const Eigen::Vector3d& grip);

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const Scene& scene_;
  SpotChoice spots_;
  std::optional<Eigen::Vector2d> spot_;
  // Where the held object was seen last, from where it should be by the gripper's place.
  Eigen::Vector3d held_off_mm_ = Eigen::Vector3d::Zero();
};

// The name a target is told under: its object, the object below, the place, or `table`.
Datum target_name(const Datum& target);

// The aim as the servo's errors. `travel_mm` is the height that is safe.
ServoErrors servo_errors(const Aim& aim, const CameraView& view, double mark_before_grip_mm, double travel_mm);
ServoPixels servo_pixels(const Aim& aim, const CameraView& view);

}  // namespace pizarra::coordinator
