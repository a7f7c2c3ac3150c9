#include "drivers/simulation/controllers/ptu_commands.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "drivers/simulation/controllers/ptu_axis_command.hpp"

namespace pizarra::simulation {

namespace {

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
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

std::optional<PtuAnswer> turn_limits(PtuUnit& unit, std::string_view command) {
  PtuModes& modes = unit.modes;
  if (command == "L") {
    if (!modes.limits) return PtuAnswer{"* Limit bounds are DISABLED (hard limits only: use care)"};
    return PtuAnswer{
        fmt::format("* Limit bounds are ENABLED ({} limits enabled)", modes.user_limits ? "user" : "soft")};
  }
  if (command != "LE" && command != "LD" && command != "LU") return std::nullopt;
  modes.limits = command != "LD";
  modes.user_limits = command == "LU";
  return PtuAnswer{"*"};
}

// Whether speeds have a sign that says where to.
std::optional<PtuAnswer> turn_speed_control(PtuUnit& unit, std::string_view command) {
  if (command == "C") {
    const std::string_view mode = unit.pure_velocity ? "pure velocity" : "independent";
    std::string sentence = fmt::format("{} speed control mode", mode);
    if (unit.modes.verbose) sentence.front() = static_cast<char>(std::toupper(sentence.front()));
    return PtuAnswer{"* " + sentence};
  }
  if (command != "CI" && command != "CV") return std::nullopt;
  unit.pure_velocity = command == "CV";
  unit.pan.velocity = 0;
  unit.tilt.velocity = 0;
  return PtuAnswer{"*"};
}

// Places and speeds of both axes, all of them or none.
PtuAnswer go_both(PtuUnit& unit, std::string_view numbers) {
  std::array<int, 4> wanted{};
  for (int& number : wanted) {
    const std::size_t comma = std::min(numbers.find(','), numbers.size());
    const std::optional<int> value = ptu_number(numbers.substr(0, comma));
    const bool last = &number == &wanted.back();
    if (!value || last != (comma == numbers.size())) return {std::string(illegal_argument)};
    number = *value;
    numbers.remove_prefix(std::min(comma + 1, numbers.size()));
  }
  PtuAxisCommand pan(unit, unit.pan);
  PtuAxisCommand tilt(unit, unit.tilt);
  for (std::string refusal : {pan.refusal_of_place(wanted[0]), tilt.refusal_of_place(wanted[1]),
                              pan.refusal_of_speed(wanted[2]), tilt.refusal_of_speed(wanted[3])}) {
    if (!refusal.empty()) return {std::move(refusal)};
  }
  unit.pan.axis.speeds().speed = wanted[2];
  unit.tilt.axis.speeds().speed = wanted[3];
  static_cast<void>(pan.obey(fmt::format("P{}", wanted[0])));
  static_cast<void>(tilt.obey(fmt::format("P{}", wanted[1])));
  return {"*"};
}

std::optional<PtuAnswer> say_what_it_is(const PtuUnit& unit, std::string_view command) {
  constexpr std::string_view version = "2.14.0";
  if (command == "V") return PtuAnswer{fmt::format("* Pan-Tilt Controller v{} emulated {}", version, unit.model->name)};
  if (command == "VV") return PtuAnswer{fmt::format("* {}", version)};
  if (command == "VM") return PtuAnswer{fmt::format("* {}", unit.model->name)};
  if (command == "VS") return PtuAnswer{"* emulated"};
  return std::nullopt;
}

PtuAnswer set_reset_at_power_up(PtuUnit& unit, bool pan, bool tilt) {
  unit.modes.pan_reset_at_power_up = pan;
  unit.modes.tilt_reset_at_power_up = tilt;
  return {"*"};
}

PtuAnswer obey_whole(PtuUnit& unit, std::string_view command) {
  for (const auto& about : {turn_switch, turn_limits, turn_speed_control}) {
    if (const std::optional<PtuAnswer> turned = about(unit, command)) return *turned;
  }
  if (const std::optional<PtuAnswer> said = say_what_it_is(unit, command)) return *said;
  if (command.starts_with('B')) return go_both(unit, command.substr(1));
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
    PtuAxisCommand about(unit, word[0] == 'P' ? unit.pan : unit.tilt);
    return {about.obey(std::string_view(word).substr(1))};
  }
  return obey_whole(unit, word);
}

}  // namespace pizarra::simulation
