#pragma once

// The object between the fingers, from a grip to the release: whether it is still there, by the gripper's own word, and
// how high it is carried.
//
//   carried.begin(opening_mm);                                  // the fingers closed on something
//   Result<void> done = co_await carried.keep(raise());         // slipped: the step ended early
//   carried.end();                                              // they are about to open
//
// It is carried no higher than it takes to pass over all that stands. So a cube that slips falls less far, and mostly
// comes to rest near by and upright. Then the arm stays as low until the next grip. While an object is not seen it goes
// as high as the arm travels otherwise; also after a step that failed, since what met something may hang askew, and
// there are places to which the arm cannot come in low. Over a tower of more than four the arm travels higher.

#include "agents/coordinator/act/arm.hpp"
#include "agents/coordinator/perceive/surroundings.hpp"

namespace pizarra::coordinator {

class Carried {
 public:
  Carried(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
          Surroundings& surroundings, Arm& arm)
      : context_(context), options_(options), domain_(domain), surroundings_(surroundings), arm_(arm) {}

  void begin(double opening_mm) {
    held_mm_ = opening_mm;
    slipped_ = false;
    goes_high_ = false;
  }
  void end() { held_mm_.reset(); }
  // Nothing is between the fingers any more that should be.
  bool is_lost() const;
  // Before every motion of a step. Failure: slipped.
  Result<void> check() const;
  // Carries out a step. Its motion is cut short once what is carried is lost. Failures: slipped, and those of the step.
  Task<Result<void>> keep(Task<Result<void>> step);
  // The height at which the arm travels, with or without something between its fingers.
  double height_mm() const;
  // From now on until the next grip: for a place near the arm's foot, to which the arm cannot come in low.
  void go_high() { goes_high_ = true; }

 private:
  Task<void> cut_short_when_lost();
  bool goes_low() const;
  // Of the grip, to pass over all that stands.
  double height_over_all_mm() const;

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  Surroundings& surroundings_;
  Arm& arm_;
  std::optional<double> held_mm_;  // the opening at the grip, while it is carried
  bool slipped_ = false;           // what was carried last
  bool goes_high_ = false;
};

}  // namespace pizarra::coordinator
