#pragma once

// Looks for the objects of a goal (steps b and c): the eyes find each one. Where it does not show, the head turns, if
// the cameras stand on one; what may hide it is set aside, one thing after another; and the table beside the images is
// swept.
//
// An object that the goal only quantifies over is looked for once it has been seen in this life. Where that is in vain
// it counts as away, until it is seen again or another goal comes.
//
//   ObjectSearch search(context, options, domain, surroundings, story, eyes, head, plan, runner, rescues,
//   interruption); search.begin();                                            // a goal, or a stage of it Result<void>
//   there = co_await search.look_for(goal);       // missing-object names all that it names and are missing

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agents/coordinator/act/rescues.hpp"
#include "agents/coordinator/pursue/goal_in_hand.hpp"
#include "agents/coordinator/pursue/head_search.hpp"
#include "agents/coordinator/pursue/plan_in_hand.hpp"

namespace pizarra::coordinator {

class ObjectSearch {
 public:
  ObjectSearch(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
               Surroundings& surroundings, Story& story, Eyes& eyes, HeadSearch& head, const PlanInHand& plan,
               TaskRunner& runner, Rescues& rescues, const Interruption& interruption)
      : context_(context),
        options_(options),
        domain_(domain),
        surroundings_(surroundings),
        story_(story),
        eyes_(eyes),
        head_(head),
        plan_(plan),
        runner_(runner),
        rescues_(rescues),
        interruption_(interruption) {}

  // Forgets what was set aside.
  void begin();
  // Failures: missing-object, interrupted, camera-doubtful, hold-ups, and the eyes'.
  Task<Result<void>> look_for(Goal goal);
  // Of a goal about some objects of a type: any other might do. Failures as look_for(), but missing-object.
  Task<Result<void>> look_for_others(Goal goal);
  // Tries once to set something aside that may hide the object, but not `but`. Whether there was something to try.
  Task<Result<bool>> clear_view_of(std::int64_t goal, std::string missing, std::string but = "");
  // A hand may be at work: what is planned on should have come to rest. Not for ever, and only for what shows: the rest
  // is searched for.
  Task<void> await_steady(std::vector<std::string> objects);
  // Somebody holds a thing in the air: it is waited for until it is put down. Not for ever.
  Task<void> await_put_down();
  // Whether the gripper is low enough to hide something.
  bool arm_stands_low() const;

 private:
  // Tries in vain to take a cube that lay there.
  struct Failed {
    Eigen::Vector3d at_mm;
    int times = 0;
  };
  // In search of one object after another. The search does nothing twice: `done` has what was moved, or could not be
  // moved however often that was tried.
  struct SetAside {
    std::set<std::string> done;
    std::map<std::string, Failed> failed;
    std::vector<Push> swept;
    // Of those done, what was moved for the objects before: it may stand before the next one now.
    std::set<std::string> moved_before;
    // Of the object in hand.
    bool has_swept = false;
    int stops = 0;           // how often something in its way ended the newest sweep
    bool laid_down = false;  // what the gripper held
    bool head_looked = false;

    // What was moved may have been in their way.
    void try_failed_again() {
      for (const auto& [name, tries] : failed) done.erase(name);
      failed.clear();
    }
    void next_object() {
      moved_before = done;
      std::erase_if(moved_before, [this](const std::string& name) { return failed.contains(name); });
      has_swept = laid_down = head_looked = false;
      stops = 0;
    }
  };

  Task<Result<void>> look_for_named(Goal goal);
  // Seen before, not seen now, and not known to be away.
  std::vector<std::string> others_unseen() const;
  Task<Result<void>> look_once_for(std::int64_t goal, std::string object, SetAside& set_aside);
  // Whether it came into view as the head turned, or clear_view() tried something.
  Task<Result<bool>> look_elsewhere(std::int64_t goal, std::string object, SetAside& set_aside);
  // Whether one rescue was tried, after which one looks again: to lay down what the gripper holds, to set something
  // aside that may hide the missing object, or to sweep the object into view. The second time that the same thing hides
  // it, what that stood on goes too: there the plan would put it again.
  Task<Result<bool>> clear_view(std::int64_t goal, std::string missing, SetAside& set_aside);
  Task<Result<bool>> lay_down_held(std::string missing, SetAside& set_aside);
  Task<Result<bool>> search_the_table(std::int64_t goal, std::string missing, SetAside& set_aside);
  Task<Result<bool>> sweep_in(std::int64_t goal, std::string missing, SetAside& set_aside);
  // An object that stands before the place where the missing one was seen last, and was not moved for it.
  std::optional<std::string> stands_before(const std::string& missing, const SetAside& set_aside) const;
  // Whether such a thing stands there, in a calm scene, and the arm hides nothing.
  bool seems_hidden(const std::string& object, const SetAside& set_aside) const;
  std::optional<std::string> to_set_aside(std::int64_t goal, const std::string& missing,
                                          const SetAside& set_aside) const;
  Task<Result<void>> set_aside_before(std::string before, std::string missing, SetAside& set_aside);
  // Counts a failure to set it aside. Whether that failed often enough where it lies.
  bool fails_for_good(const std::string& before, SetAside& set_aside) const;
  // Drops the objects that count as there no more, and those that another stands before.
  void drop_hidden(std::vector<std::string>& objects) const;
  // Drops the objects that none of the newest looks has shown.
  void drop_unseen(std::vector<std::string>& objects, std::uint64_t looks) const;

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Story& story_;
  Eyes& eyes_;
  HeadSearch& head_;
  const PlanInHand& plan_;
  TaskRunner& runner_;
  Rescues& rescues_;
  const Interruption& interruption_;
  int set_aside_ = 0;                                  // how often something was, since the search began
  int swept_ = 0;                                      // the same of sweeps
  std::set<std::pair<std::string, std::string>> hid_;  // a missing object, and what was set aside before it
  std::set<std::string> away_;                         // looked for in vain, for this goal
  std::int64_t away_for_ = 0;
};

// What ends a search, and rescues on its way. A rescue that fails otherwise has been tried.
bool ends_search(const Failure& failure);

}  // namespace pizarra::coordinator
