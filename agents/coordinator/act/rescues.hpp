#pragma once

// The actions for a cell in which the plan cannot go on: a rescue belongs to no operation and has no effect that is
// planned on. It changes what stands in the way, and what comes of it is seen, and planned on, afterwards.
//
//   Result<void> done = co_await rescues.set_aside("square");
//
// Each is a task of the runner's, and fails as those do.

#include "agents/coordinator/act/pushes.hpp"
#include "agents/coordinator/act/task_runner.hpp"

namespace pizarra::coordinator {

class Rescues {
 public:
  Rescues(const TaskDomain& domain, const Scene& scene, Story& story, Arm& arm, Pushes& pushes, TaskRunner& runner,
          double widest_mm)
      : domain_(domain),
        scene_(scene),
        story_(story),
        arm_(arm),
        pushes_(pushes),
        runner_(runner),
        widest_mm_(widest_mm) {}

  // By how far its fingers are open.
  bool seems_to_hold() const { return is_held(scene_.opening_mm().value_or(0)); }
  // Puts down on a free spot whatever the gripper holds, `object` or another, so that the eyes can tell what it is.
  // Nothing is done where it holds nothing.
  Task<Result<void>> lay_down(std::string object);
  // After it has slipped: the fingers open, out of its way, while it comes to rest.
  Task<Result<void>> let_it_lie(std::string object);
  // Takes `object` to a free spot, away from what it may hide.
  Task<Result<void>> set_aside(std::string object);
  // Whether the object was seen last on the table, where the images now cut it off.
  bool lay_cut_off(const std::string& object) const { return pushes_.lay_cut_off(object); }
  // What the images cut off and is seen nevertheless. Above it the gripper, and what it holds, are out of view.
  Task<Result<void>> bring_into_view(std::string object);
  // The likeliest that is not among those that were made. None where it may lie nowhere else.
  std::optional<Push> next_sweep(const std::string& missing, bool was_here, const std::vector<Push>& swept) const;
  // Brings into view what may lie beyond the border of the images.
  Task<Result<void>> sweep_in(std::string missing, Push sweep);
  // Pushes what the operation is about and cannot be grasped where it lies, so that it lies otherwise. A held object is
  // laid down, and the object that it could not be put on is pushed out of its row where it is crowded. Failure stuck:
  // the gripper's sensor does not follow the fingers, so that nothing is known of what they met.
  Task<Result<void>> loosen(Datum operation);

 private:
  Task<Result<void>> lay_down_at(Datum spot, std::string object);
  Task<Result<void>> take_away(std::string object);
  Task<Result<void>> grasp(std::string object);
  bool is_away_from(const std::string& object, const Eigen::Vector3d& place_mm) const;
  Task<Result<void>> clear_way_inwards(std::string object);
  // Whether the raised fingers stay as open as they were although they are to close.
  Task<Result<bool>> fingers_stay_at(double opened_mm);
  // Whether fingers that closed so far have something as wide as a cube between them. Where they meet on an edge they
  // close further; across a cube's edges they jam wider.
  bool is_held(double closed_mm) const;

  const TaskDomain& domain_;
  const Scene& scene_;
  Story& story_;
  Arm& arm_;
  Pushes& pushes_;
  TaskRunner& runner_;
  double widest_mm_;  // to which the fingers open
};

}  // namespace pizarra::coordinator
