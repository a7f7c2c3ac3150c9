#include "drivers/simulation/controllers/ptu_commands.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace pizarra::simulation {

namespace {

constexpr std::string_view illegal_command = "! Illegal command entered";
constexpr std::string_view illegal_argument = "! Illegal argument entered";

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

std::optional<int> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// One exchange about one axis.
class AxisCommand {
 public:
  AxisCommand(PtuUnit& unit, PtuChannel& channel) : unit_(unit), channel_(channel), axis_(channel.axis) {}
  std::string obey(char what, std::string_view argument);

 private:
  std::string say(std::string_view before, double value, std::string_view after = "") const;
  std::string query(char what) const;
  std::string set(char what, int value);
  std::string go(int target);
  std::string set_speed(int value);
  std::string power(std::string_view& mode, bool holding, std::string_view argument) const;

  PtuUnit& unit_;
  PtuChannel& channel_;
  PtuAxis& axis_;
};

std::string AxisCommand::say(std::string_view before, double value, std::string_view after) const {
  if (!unit_.modes.verbose) return fmt::format("* {}", value);
  const std::string sentence = fmt::format(fmt::runtime(before), channel_.name);
  return fmt::format("* {} {}{}", sentence, value, after);
}

std::string AxisCommand::query(char what) const {
  const PtuSpeeds& speeds = axis_.speeds();
  switch (what) {
    case 'P':
      return say("Current {} position is", axis_.position());
    case 'O':
      return say("Target {} position is", axis_.target());
    case 'N':
      return say("Minimum {} position is", axis_.model().low);
    case 'X':
      return say("Maximum {} position is", axis_.model().high);
    case 'R':
      return fmt::format("* {}{}", axis_.model().arc_seconds, unit_.modes.verbose ? " seconds arc per position" : "");
    case 'S':
      return say("Target {} speed is", speeds.speed, " positions/sec");
    case 'D':
      return say("Current {} speed is", axis_.moving_speed(), " positions/sec");
    case 'U':
      return say("Maximum {} speed is", speeds.upper, " positions/sec");
    case 'L':
      return say("Minimum {} speed is", speeds.lower, " positions/sec");
    case 'B':
      return say("Current {} base speed is", speeds.base, " positions/sec");
    case 'A':
      return say("{} acceleration is", speeds.acceleration, " positions/sec^2");
    default:
      return std::string(illegal_command);
  }
}

std::string AxisCommand::go(int target) {
  if (unit_.modes.limits && target > axis_.model().high) {
    return fmt::format("! Maximum allowable {} position is {}", channel_.name, axis_.model().high);
  }
  if (unit_.modes.limits && target < axis_.model().low) {
    return fmt::format("! Minimum allowable {} position is {}", channel_.name, axis_.model().low);
  }
  channel_.awaited = target;
  if (unit_.modes.immediate) axis_.go_to(target);
  return "*";
}

std::string AxisCommand::set_speed(int value) {
  PtuSpeeds& speeds = axis_.speeds();
  if (value > speeds.upper) {
    return fmt::format("! {} speed cannot exceed {} positions/sec", channel_.name, speeds.upper);
  }
  if (value < speeds.lower) {
    return fmt::format("! {} speed cannot be less than {} positions/sec", channel_.name, speeds.lower);
  }
  speeds.speed = value;
  return "*";
}

std::string AxisCommand::set(char what, int value) {
  PtuSpeeds& speeds = axis_.speeds();
  const int top = axis_.model().top_speed;
  const auto keep = [](int& setting, int to, int low, int high) {
    if (to < low || to > high) return std::string(illegal_argument);
    setting = to;
    return std::string("*");
  };
  constexpr int most_acceleration = 1'000'000;
  switch (what) {
    case 'P':
      return go(value);
    case 'O':
      return go(axis_.position() + value);
    case 'S':
      return set_speed(value);
    case 'D':
      return set_speed(speeds.speed + value);
    case 'U':
      return keep(speeds.upper, value, speeds.lower, top);
    case 'L':
      return keep(speeds.lower, value, 1, speeds.upper);
    case 'B':
      return keep(speeds.base, value, 1, speeds.upper);
    case 'A':
      return keep(speeds.acceleration, value, 1, most_acceleration);
    default:
      return std::string(illegal_command);
  }
}

std::string AxisCommand::power(std::string_view& mode, bool holding, std::string_view argument) const {
  if (argument.empty()) {
    if (!unit_.modes.verbose) return fmt::format("* {}", mode);
    return fmt::format("* {} in {} {} power mode", channel_.name, mode, holding ? "hold" : "move");
  }
  const char third = holding ? 'O' : 'H';
  if (argument == "R") {
    mode = "REGULAR";
  } else if (argument == "L") {
    mode = "LOW";
  } else if (argument.size() == 1 && argument.front() == third) {
    mode = holding ? "OFF" : "HIGH";
  } else {
    return std::string(illegal_argument);
  }
  return "*";
}

std::string AxisCommand::obey(char what, std::string_view argument) {
  if (what == 'H') return power(channel_.hold, true, argument);
  if (what == 'M') return power(channel_.move, false, argument);
  if (argument.empty()) return query(what);
  const std::optional<int> value = number_in(argument);
  if (!value) return std::string(illegal_argument);
  // A count beyond any unit's is a slip of the other side, not a place.
  constexpr int most = 10'000'000;
  if (*value > most || *value < -most) return std::string(illegal_argument);
  return set(what, *value);
}

PtuAnswer halt(PtuUnit& unit, bool pan, bool tilt) {
  for (PtuChannel* channel : {pan ? &unit.pan : nullptr, tilt ? &unit.tilt : nullptr}) {
    if (channel == nullptr) continue;
    channel->axis.halt();
    channel->awaited = channel->axis.target();
  }
  return {"*"};
}

PtuAnswer await(PtuUnit& unit) {
  unit.pan.axis.go_to(unit.pan.awaited);
  unit.tilt.axis.go_to(unit.tilt.awaited);
  return {.text = "*", .wait = true};
}

// A flag's query, its two settings, and what they are called.
struct Switch {
  char letter;
  bool PtuModes::*flag;
  std::string_view on;
  std::string_view off;
  std::string_view says_on;
  std::string_view says_off;
};

constexpr Switch switches[] = {
    {'E', &PtuModes::echo, "EE", "ED", "Echoing ON", "Echoing OFF"},
    {'F', &PtuModes::verbose, "FV", "FT", "ASCII verbose mode", "ASCII terse mode"},
    {'L', &PtuModes::limits, "LE", "LD", "Limit bounds are ENABLED (soft limits enabled)", "Limit bounds are DISABLED"},
};

std::optional<PtuAnswer> turn_switch(PtuUnit& unit, std::string_view command) {
  for (const Switch& each : switches) {
    bool& flag = unit.modes.*each.flag;
    if (command.size() == 1 && command.front() == each.letter) {
      return PtuAnswer{fmt::format("* {}", flag ? each.says_on : each.says_off)};
    }
    if (command != each.on && command != each.off) continue;
    flag = command == each.on;
    return PtuAnswer{"*"};
  }
  return std::nullopt;
}

PtuAnswer set_reset_at_power_up(PtuUnit& unit, bool pan, bool tilt) {
  unit.modes.pan_reset_at_power_up = pan;
  unit.modes.tilt_reset_at_power_up = tilt;
  return {"*"};
}

PtuAnswer obey_whole(PtuUnit& unit, std::string_view command) {
  if (const std::optional<PtuAnswer> turned = turn_switch(unit, command)) return *turned;
  if (command == "I" || command == "S") {
    unit.modes.immediate = command == "I";
    return {"*"};
  }
  if (command == "A") return await(unit);
  if (command == "H") return halt(unit, true, true);
  if (command == "HP") return halt(unit, true, false);
  if (command == "HT") return halt(unit, false, true);
  if (command == "R") return {.text = "*", .reset_pan = true, .reset_tilt = true};
  if (command == "RP") return {.text = "*", .reset_pan = true};
  if (command == "RT") return {.text = "*", .reset_tilt = true};
  if (command == "RE") return set_reset_at_power_up(unit, true, true);
  if (command == "RD") return set_reset_at_power_up(unit, false, false);
  if (command == "V") return {fmt::format("* Pan-Tilt Controller v2.14.0 emulated {}", unit.model->name)};
  if (command == "DS" || command == "DR" || command == "DF") {
    if (command == "DS") unit.save();
    if (command == "DR") unit.restore();
    if (command == "DF") unit.restore_factory();
    return {"*"};
  }
  return {std::string(illegal_command)};
}

}  // namespace

PtuAnswer obey(PtuUnit& unit, std::string_view command) {
  const std::string word = upper(command);
  if (word.size() >= 2 && (word[0] == 'P' || word[0] == 'T')) {
    AxisCommand about(unit, word[0] == 'P' ? unit.pan : unit.tilt);
    return {about.obey(word[1], std::string_view(word).substr(2))};
  }
  return obey_whole(unit, word);
}

}  // namespace pizarra::simulation
