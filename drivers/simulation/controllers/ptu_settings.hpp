#pragma once

// What the controller of an emulated pan-tilt unit remembers besides its axes.

#include "drivers/simulation/controllers/ptu_axis.hpp"

namespace pizarra::simulation {

struct PtuModes {
  bool echo = true;
  bool verbose = true;
  bool immediate = true;
  bool limits = true;
  bool pan_reset_at_power_up = true;
  bool tilt_reset_at_power_up = true;
};

// One axis with what it was told in slaved mode and does when awaited.
struct PtuChannel {
  std::string_view name;  // Pan, Tilt
  char letter;            // P, T
  PtuAxis axis;
  int awaited;  // counts: where it goes with the next A
  std::string_view hold = "REGULAR";
  std::string_view move = "REGULAR";

  PtuChannel(std::string_view the_name, const PtuAxisModel& model, const PtuSpeeds& speeds)
      : name(the_name), letter(the_name.front()), axis(model, speeds), awaited(0) {}
};

// The whole unit. What DS saves is kept without power.
struct PtuUnit {
  explicit PtuUnit(const PtuModel& the_model)
      : model(&the_model),
        pan("Pan", the_model.pan, the_model.speeds),
        tilt("Tilt", the_model.tilt, the_model.speeds) {}

  void advance(Duration time);
  bool moving() const { return pan.axis.moving() || tilt.axis.moving(); }
  void save();
  void restore();
  void restore_factory();

  const PtuModel* model;
  PtuModes modes;
  PtuChannel pan;
  PtuChannel tilt;

 private:
  struct Saved {
    PtuModes modes;
    PtuSpeeds pan;
    PtuSpeeds tilt;
  };
  Saved saved_{modes, model->speeds, model->speeds};
};

}  // namespace pizarra::simulation
