#pragma once

// The settings that the controller of an emulated pan-tilt unit keeps besides its axes.

#include "drivers/simulation/controllers/ptu_axis.hpp"

namespace pizarra::simulation {

struct PtuModes {
  bool echo = true;
  bool verbose = true;
  bool immediate = true;
  bool limits = true;
  bool user_limits = false;  // those that were set hold, not the unit's own
  bool pan_reset_at_power_up = true;
  bool tilt_reset_at_power_up = true;
};

// One axis with what it was told in slaved mode and does when awaited.
struct PtuChannel {
  std::string_view name;  // Pan, Tilt
  char letter;            // P, T
  PtuAxis axis;
  int awaited;       // counts: where it goes with the next A
  int velocity = 0;  // counts/s, as last told in pure velocity mode
  int user_low;      // counts
  int user_high;
  std::string_view hold = "REGULAR";
  std::string_view move = "REGULAR";

  PtuChannel(std::string_view the_name, const PtuAxisModel& model, const PtuSpeeds& speeds)
      : name(the_name),
        letter(the_name.front()),
        axis(model, speeds),
        awaited(0),
        user_low(model.low),
        user_high(model.high) {}
};

// The whole unit. What DS saves is kept without power.
struct PtuUnit {
  explicit PtuUnit(const PtuModel& the_model)
      : model(&the_model),
        pan("Pan", the_model.pan, the_model.speeds),
        tilt("Tilt", the_model.tilt, the_model.speeds) {}

  void advance(Duration time);
  // How far an axis may be sent now: anywhere where the limits are off.
  int low(const PtuChannel& channel) const;
  int high(const PtuChannel& channel) const;
  bool moving() const { return pan.axis.moving() || tilt.axis.moving(); }
  void save();
  void restore();
  void restore_factory();

  const PtuModel* model;
  PtuModes modes;
  PtuChannel pan;
  PtuChannel tilt;
  // Speeds have a sign and are what moves the axes. Never so after power-up, nor saved.
  bool pure_velocity = false;

 private:
  struct Saved {
    PtuModes modes;
    PtuSpeeds pan;
    PtuSpeeds tilt;
  };
  Saved saved_{modes, model->speeds, model->speeds};
};

}  // namespace pizarra::simulation
