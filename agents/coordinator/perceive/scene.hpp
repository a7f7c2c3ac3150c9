#pragma once

// Where things stand, by the newest looks and by what the arm, the gripper and the camera's head say of themselves.
// Nothing is watched or told here: Surroundings takes everything in.
//
//   Scene scene(options, domain);
//   scene.take_camera(model);                              // and what others tell of themselves
//   if (scene.places_next_look()) scene.take_look(frame, *perceived);
//   scene.grip_mm();

#include <set>

#include "agents/coordinator/geometry/camera_watch.hpp"
#include "agents/coordinator/geometry/sight_lines.hpp"
#include "agents/coordinator/geometry/sightings.hpp"
#include "agents/coordinator/options.hpp"
#include "agents/coordinator/plan/task_domain.hpp"
#include "lisp/forms/perceived_look.hpp"

namespace pizarra::coordinator {

class Scene {
 public:
  // Both outlive it.
  Scene(const CoordinatorOptions& options, const TaskDomain& domain);

  const Sightings& sightings() const { return sightings_; }
  // None before the camera-model fact is there.
  const std::optional<CameraView>& view() const { return view_; }
  const CameraWatch& camera() const { return camera_; }
  // How the camera's head is turned; none while it turns, or nobody knows. In its middle where there is none.
  const std::optional<HeadTurn>& head() const { return head_; }
  std::optional<double> opening_mm() const { return opening_mm_; }
  // How far the tool is turned about the base's z axis, by the arm's word.
  std::optional<double> tool_yaw_deg() const;
  // The point of the table about which the arm turns.
  const Eigen::Vector3d& foot_mm() const { return foot_mm_; }
  // From the end effector's mark to where the mark of a held object of the largest size would stand. There is a view.
  Eigen::Vector3d mark_to_front_mm() const;
  // Where the mark of a held object of that size would stand: below the end effector's mark, or, while that is not
  // seen, by the arm's own word and how far off that was when the two could last be compared.
  std::optional<Eigen::Vector3d> grip_mm() const;
  // How the eyes look past cubes that stand so much further to the side. There is a view.
  SightLines sight_lines(double margin_mm) const;
  // Whether the camera should show the end effector's mark: also where the arm does not say where it is.
  bool mark_in_view() const;
  // From there to where the mark of this object would stand: further from the camera, where it is smaller than others.
  // There is a view.
  Eigen::Vector3d set_back_mm(std::string_view name) const;
  // From the object's mark to where it would stand on the face that looks as the fingers do; zero while the face is not
  // known. A cube that lies far round shows its mark on another face.
  Eigen::Vector3d face_to_fingers_mm(const std::string& name) const;
  // How far the fingers are turned, as Arm::face() has it, to grasp the object: after its mark, so that it faces the
  // camera once the cube is held and squared up.
  double fingers_deg(std::string_view name) const;
  // The middle of the cube that bears the mark.
  Eigen::Vector3d centre_mm(const std::string& name, const Sighting& sighting) const;
  // A seen cube that stands before the place where the missing one was seen last. Of a pile, its top. None of `but`.
  std::optional<std::string> stands_before(const std::string& missing, const std::set<std::string>& but) const;
  // A seen cube that may hide the missing one: what stands before its place, else what stands nearest the camera, well
  // before the row of spots, else what stands nearest that place: it may have fallen behind. Of a pile, its top. None
  // of `but`. `was_here`: it was seen in an earlier life, so that it is not simply away.
  std::optional<std::string> may_hide(const std::string& missing, const std::set<std::string>& but,
                                      bool was_here) const;
  // How far from where it was seen last a cube may have come to lie by itself. One that was higher up, as in the
  // gripper, may lie as much further.
  double falls_within_mm(const Sighting& last) const;
  // Of the seen cubes within the reach of a fall around it: the highest of the nearest pile.
  std::optional<std::string> neighbour_of(const std::string& name) const;
  // The seen cube that it stands on.
  std::optional<std::string> under(const std::string& name) const;
  // A seen object that hangs in the air, and not in the gripper: somebody holds it.
  std::optional<std::string> held_by_somebody() const;
  // Whether nothing moves that was seen lately and is not in the gripper.
  bool calm() const;
  // Whether all these objects were seen lately and lie still.
  bool still(const std::vector<std::string>& objects) const;
  // Whether one of these objects has moved within so many of the newest looks.
  bool moved_within(std::uint64_t looks, const std::vector<std::string>& objects) const;

  // The facts that others tell of themselves. While the head turns, or nobody knows how it stands, nothing can be
  // placed.
  void take_camera(const CameraModel& model);
  // Looks are placed again once the camera is known anew.
  void forget_camera();
  void take_head(std::optional<HeadTurn> turn);
  void take_opening(double mm) { opening_mm_ = mm; }
  void take_pose(const Eigen::Isometry3d& tool);
  void take_foot(const Eigen::Vector3d& foot_mm) { foot_mm_ = foot_mm; }
  // While it moves its word for where it is may be old.
  void take_arm(bool rests);
  // An object that the gripper hides may not be where it was.
  void doubt_hidden() { sightings_.end_excuses(); }
  void doubt_camera() { camera_.doubt(); }
  void take_camera_pose(const CameraMeasured& measured);

  // Whether the next look can be placed: the camera's model and its head are known, and the head stands long enough for
  // no look under way to be older. Counts the looks that cannot.
  bool places_next_look();
  // The situation in which the next look is understood. There is a view.
  forms::LookSituation situation() const;
  // What it tells of where the camera stands. Where a look is known to have been captured while the arm rested where it
  // says that it is, the places that both give for the gripper are compared at once; else only after two looks of rest.
  CameraWatch::News take_look(std::int64_t frame, const forms::PerceivedLook& look, bool captured_at_rest);

 private:
  // Where a face looks that is turned so far to the right of facing the camera; of length 1.
  Eigen::Vector3d looks_towards(double yaw_deg) const;
  // The direction in which the fingers look, by the arm's word. There is one, and a view.
  Eigen::Vector3d fingers_look() const;
  void turn_view();
  Eigen::Vector3d held_front_by_arm_mm() const;
  std::optional<Eigen::Vector3d> grip_by_arm_mm() const;
  // After looks that may show the arm moving.
  bool is_late_enough() const;
  bool fingers_hold() const;
  void note_held(std::span<const forms::SeenObject> seen);
  void carry_held();
  void note_covered(std::span<const std::string> hidden_by_gripper);
  void compare_pose();
  CameraWatch::News watch_camera();
  std::optional<std::string> foremost(const std::set<std::string>& but) const;
  std::optional<std::string> nearest_to(const std::string& missing, const std::set<std::string>& but,
                                        bool was_here) const;
  std::string top_of_pile(std::string name) const;
  bool may_rest_on_another(const std::string& name, const Eigen::Vector3d& centre_mm) const;

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Sightings sightings_;
  CameraWatch camera_;
  std::optional<CameraModel> model_;
  std::optional<HeadTurn> head_;
  int blurred_looks_ = 0;  // that are still to come and may have been taken while it turned
  std::optional<CameraView> view_;
  std::optional<double> opening_mm_;
  std::optional<Eigen::Isometry3d> tool_;  // by the arm's word
  Eigen::Vector3d foot_mm_ = Eigen::Vector3d::Zero();
  bool rests_ = false;                                     // by the arm's word, as the pose is
  std::uint64_t pose_look_ = 0;                            // the newest when the arm told its pose, or came to rest
  Eigen::Vector3d pose_off_mm_ = Eigen::Vector3d::Zero();  // from where the arm says its grip is to where it is seen
  struct Compared {
    Eigen::Vector3d tool_mm;
    Eigen::Vector3d off_mm;
  };
  std::optional<Compared> compared_;  // when the tool was at another place last, or came here
};

}  // namespace pizarra::coordinator
