#pragma once

// What the coordinator perceives of its cell: it watches the agents' facts, turns every look of vision into places and
// the domain's predicates, and tells those. What others tell or retract of them is put right. Nothing here acts.
//
// Lifecycle: start() spawns the watches, which go on until it is destroyed.
//
//   surroundings.start();
//   bool seen = co_await surroundings.look_after(surroundings.looks() + 1, deadline);   // a look that began since
//   surroundings.beliefs();                                                             // {(on circle triangle), ...}

#include <functional>
#include <map>
#include <optional>
#include <set>

#include "agents/coordinator/event_log.hpp"
#include "agents/coordinator/geometry/sightings.hpp"
#include "agents/coordinator/options.hpp"
#include "agents/coordinator/perceive/beliefs.hpp"
#include "agents/coordinator/plan/task_domain.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::coordinator {

class Surroundings {
 public:
  // Everything outlives it. Facts it tells stand under the service's presence, so that they go with the coordinator.
  Surroundings(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
               const runtime::Service& service, Story& story);

  void start();
  // Called after beliefs changed, with what changed.
  void on_change(std::function<void(const Beliefs::Change&)> observer) { observer_ = std::move(observer); }

  const Sightings& sightings() const { return sightings_; }
  const Facts& beliefs() const { return beliefs_.facts(); }
  std::uint64_t looks() const { return sightings_.looks(); }
  // None before the camera-model fact is there.
  const std::optional<CameraView>& view() const { return view_; }
  std::optional<double> opening_mm() const { return opening_mm_; }
  // From the end effector's mark to where the mark of a held object would stand. There is a view.
  Eigen::Vector3d mark_to_front_mm() const;
  // Where the mark of a held object would stand: below the end effector's mark, or, while that is not seen, by the
  // arm's own word and how far off that was when the two could last be compared.
  std::optional<Eigen::Vector3d> grip_mm() const;
  // The middle of the cube that bears the mark.
  Eigen::Vector3d centre_mm(const std::string& name, const Sighting& sighting) const;
  bool present(const std::string& agent) const { return present_.contains(agent); }
  // The frame in which a belief came or went last; 0 if it never did.
  std::int64_t changed_in(const Datum& belief) const;

  // A seen cube that may hide the missing one: what stands before the place where that was seen last, else what stands
  // nearest the camera, well before the row of spots.
  std::optional<std::string> may_hide(const std::string& missing) const;
  // Whether nothing moves that was seen lately and is not in the gripper.
  bool calm() const;
  // Whether it is calm, what is perceived is believed, and all these objects have been seen lately and lie still.
  bool steady(const std::vector<std::string>& objects) const;

  // True once more than `look` looks were made, false at the deadline.
  Task<bool> look_after(std::uint64_t look, Time deadline);
  // True once the agent is present.
  Task<bool> wait_present(std::string agent, Time deadline);
  // The newest fact of a relation of which there is one at most, such as (gripper ROBOT OPENING).
  Task<std::optional<Datum>> newest(Datum pattern);

 private:
  using Handler = void (Surroundings::*)(const Change&);
  Task<void> watch(Datum pattern, Handler handler);
  Task<void> watch_vision();
  void take_model(const Change& change);
  void take_head(const Change& change);
  void turn_view();
  void take_gripper(const Change& change);
  void take_faces(const Change& change);
  void take_pose(const Change& change);
  void take_presence(const Change& change);
  Task<void> take_look(std::int64_t frame, std::string text);
  void compare_pose();
  void excuse_hidden();
  std::optional<std::string> foremost() const;
  std::vector<Datum> measure() const;
  Result<Facts> perceive() const;
  Task<void> tell_failure(Failure why);
  void tell_places(Transaction& transaction);
  Task<void> tell_change(Beliefs::Change change);
  Task<std::vector<FactId>> evidence(Datum belief);
  // Keeps what stands on the board of one of the relations that beliefs are told in to what is believed.
  Task<void> keep_told(Datum pattern);
  Task<void> put_right(Datum pattern, Change change);
  bool is_to_be_told(const Datum& fact) const;
  Facts to_be_told(const Datum& pattern) const;

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const runtime::Service& service_;
  Story& story_;
  std::function<void(const Beliefs::Change&)> observer_;

  std::uint64_t grace_;
  Sightings sightings_;
  Beliefs beliefs_;
  std::optional<CameraModel> model_;
  // How the camera is turned; none while it turns, or nobody knows.
  std::optional<HeadTurn> head_;
  int blurred_looks_ = 0;  // that are still to come and may have been taken while it turned
  std::optional<CameraView> view_;
  std::optional<double> opening_mm_;
  std::optional<Eigen::Vector3d> pose_mm_;
  std::uint64_t pose_look_ = 0;                            // the newest when the arm told its pose
  Eigen::Vector3d pose_off_mm_ = Eigen::Vector3d::Zero();  // from where the arm says its grip is to where it is seen
  std::set<std::string, std::less<>> present_;
  std::map<std::string, Eigen::Vector3d, std::less<>> told_places_;
  bool all_told_ = true;
  LeaseId told_under_ = 0;  // the presence under which it was told
  std::string told_failure_;
  std::map<Datum, std::int64_t> changed_in_;
  WaitList changed_;
  std::vector<Job> jobs_;
};

}  // namespace pizarra::coordinator
