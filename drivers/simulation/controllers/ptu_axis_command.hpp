#pragma once

// The commands about one axis of a pan-tilt unit, those whose first letter is P or T.
//
//   PtuAxisCommand about(unit, unit.pan);
//   about.obey("P1000")          // "*", and it goes there
//   about.obey("S")              // "* Target Pan speed is 1000 positions/sec"

#include <optional>
#include <string>

#include "drivers/simulation/controllers/ptu_settings.hpp"

namespace pizarra::simulation {

inline constexpr std::string_view illegal_command = "! Illegal command entered";
inline constexpr std::string_view illegal_argument = "! Illegal argument entered";

// A count or a speed; none where the text is no whole number, or one beyond any unit's.
std::optional<int> ptu_number(std::string_view text);

class PtuAxisCommand {
 public:
  PtuAxisCommand(PtuUnit& unit, PtuChannel& channel) : unit_(unit), channel_(channel), axis_(channel.axis) {}
  // `words`: the command without the axis' letter, not empty.
  std::string obey(std::string_view words);
  // Why it would not go there, or not so fast; empty where it would.
  std::string refusal_of_place(int target) const;
  std::string refusal_of_speed(int speed) const;

 private:
  std::string say(std::string_view before, double value, std::string_view after = "") const;
  std::string query(char what) const;
  std::string set(char what, int value);
  std::string go(int target);
  std::string set_speed(int value);
  std::string set_velocity(int value);
  std::string user_limit(char which, std::string_view argument);
  std::string power(std::string_view& mode, bool holding, std::string_view argument) const;

  PtuUnit& unit_;
  PtuChannel& channel_;
  PtuAxis& axis_;
};

}  // namespace pizarra::simulation
