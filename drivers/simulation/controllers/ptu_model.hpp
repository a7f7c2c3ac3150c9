#pragma once

// The pan-tilt units that can be emulated: resolution, limits and speeds as counted by their controllers.
//
//   const PtuModel* model = find_ptu_model("ptu46-17.5");      // nullptr for a unit that is not known
//   for (const PtuModel& each : ptu_models()) ...
//
// Sources: the maker's figures for resolution, position limits and top speed; the tilt limits of the 46-70 and the
// speeds and acceleration after power-up are scaled from the 46-17.5 and unverified. Drivers ask the unit for all this.

#include <span>
#include <string_view>

namespace pizarra::simulation {

struct PtuAxisModel {
  double arc_seconds;  // of one count
  int low;             // counts
  int high;
  int top_speed;  // counts/s, by the gears
};

// After power-up; counts/s and counts/s^2.
struct PtuSpeeds {
  int speed;
  int upper;
  int lower;
  int base;
  int acceleration;
};

struct PtuModel {
  std::string_view name;
  PtuAxisModel pan;
  PtuAxisModel tilt;
  PtuSpeeds speeds;
};

std::span<const PtuModel> ptu_models();
const PtuModel* find_ptu_model(std::string_view name);

}  // namespace pizarra::simulation
