#pragma once

// The commands of a pan-tilt unit and their answers: the language of its controller, without its line.
//
//   const PtuAnswer answer = obey(unit, "PP1000");      // {"*"}, and the unit goes there
//   obey(unit, "pp")                                    // {"* Current Pan position is 0"}
//   obey(unit, "A")                                     // {"*", .wait = true}: when it stands
//
// Sources: the maker's manual of the D46's controller (2.14), for speed control modes its section 4.4.7; for `B`, `LU`
// and the limits of the user public clients of the E series. From public clients, too, is what `C` answers: its first
// letter is small in terse mode. The wording of `Illegal` answers, of `VV`, `VM` and `VS` is unverified.

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
