#pragma once

// The arm carries its mark to places before the camera until it is known where the camera stands.
//
//   if (!surroundings.scene().camera().known()) {
//     const Result<void> surveyed = co_await survey.run();
//   }
//
// Failures: camera-moved (the mark was not seen at places enough, with what to do), interrupted, absent, and the
// robot's own.

#include "agents/coordinator/act/task_runner.hpp"

namespace pizarra::coordinator {

class CameraSurvey {
 public:
  // All outlive it.
  CameraSurvey(const CoordinatorOptions& options, const TaskDomain& domain, Surroundings& surroundings, Story& story,
               Arm& arm, Eyes& eyes, ServoLoop& servo, TaskRunner& runner, const Interruption& interruption)
      : options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        arm_(arm),
        eyes_(eyes),
        servo_(servo),
        runner_(runner),
        interruption_(interruption) {}

  Task<Result<void>> run();

 private:
  // By pixel errors alone, until the looks tell at all where the camera stands; or until they are too few for that.
  Task<Result<void>> find_by_pixels();
  // To where the mark is seen at that pixel, or as near as the arm may go.
  Task<Result<void>> align_pixels(Eigen::Vector2d wanted_px);
  Eigen::Vector3d within_room(const Eigen::Vector3d& grip_mm) const;
  // Of the grip, so that the mark is at all corners of the room above the row.
  std::vector<Eigen::Vector3d> places() const;
  double lowest_mm() const;
  // The object in the gripper; empty where there is none.
  std::string held() const;
  // Whether the mark was seen there.
  Task<Result<bool>> look_from(Eigen::Vector3d grip_mm);
  Task<Result<void>> look_around(std::vector<Eigen::Vector3d> ways_mm);

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Arm& arm_;
  Eyes& eyes_;
  ServoLoop& servo_;
  TaskRunner& runner_;
  const Interruption& interruption_;
};

}  // namespace pizarra::coordinator
