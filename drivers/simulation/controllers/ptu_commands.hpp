#pragma once

// What the commands of a pan-tilt unit do and answer: the language of its controller, without its line.
//
//   const PtuAnswer answer = obey(unit, "PP1000");      // {"*"}, and the unit goes there
//   obey(unit, "pp")                                    // {"* Current Pan position is 0"}
//   obey(unit, "A")                                     // {"*", .wait = true}: when it stands
//
// Source: the maker's manual of the D46's controller; the wording of `Illegal` answers is unverified.

#include <optional>
#include <string>

#include "drivers/simulation/controllers/ptu_settings.hpp"

namespace pizarra::simulation {

struct PtuAnswer {
  std::string text;
  bool wait = false;       // to be given when the unit stands
  bool reset_pan = false;  // to be given when this has been done
  bool reset_tilt = false;
};

// `command` without its delimiter, not empty.
PtuAnswer obey(PtuUnit& unit, std::string_view command);

}  // namespace pizarra::simulation
