#pragma once

// One stepper axis of an emulated pan-tilt unit, moving in time: it starts and stops at its base speed and ramps to its
// speed and back.
//
//   PtuAxis axis(model.pan, model.speeds);
//   axis.go_to(1000);
//   axis.advance(10ms);
//   axis.position();         // counts, as its controller counts them
//
// Its controller counts steps, so that it knows where the axis is only once it has been reset: after a loss of power it
// counts from where the axis stands.

#include "blackboard/time/clock.hpp"
#include "drivers/simulation/controllers/ptu_model.hpp"

namespace pizarra::simulation {

class PtuAxis {
 public:
  PtuAxis(const PtuAxisModel& model, const PtuSpeeds& speeds) : model_(model), speeds_(speeds) {}

  void advance(Duration time);
  // To a count; the stops hold it where that lies beyond them.
  void go_to(int target);
  // Stops as soon as its acceleration allows.
  void halt();
  // To a stop and from there to the middle, whatever the count.
  void go_to_stop(bool high);
  // Whether it runs against a stop, and will stand there.
  bool hits_stop() const { return hits_stop_; }
  // Its counts are true from now on.
  void calibrate() { offset_ = 0; }
  // Stands at once and counts from here.
  void lose_power();

  int position() const;
  int target() const { return static_cast<int>(target_ - offset_); }
  // Counts/s at this moment.
  int moving_speed() const;
  bool moving() const { return at_ != target_; }
  // Degrees from the middle, as somebody beside it would measure them.
  double angle_deg() const { return at_ * model_.arc_seconds / 3600; }

  const PtuAxisModel& model() const { return model_; }
  PtuSpeeds& speeds() { return speeds_; }
  const PtuSpeeds& speeds() const { return speeds_; }

 private:
  void step(double seconds);

  PtuAxisModel model_;
  PtuSpeeds speeds_;
  double at_ = 0;  // counts from the middle
  double target_ = 0;
  double offset_ = 0;  // where the controller counts from
  double velocity_ = 0;
  bool hits_stop_ = false;
  Duration rest_{};  // of time, less than a step
};

}  // namespace pizarra::simulation
