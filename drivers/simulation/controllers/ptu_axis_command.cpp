#include "drivers/simulation/controllers/ptu_axis_command.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

std::optional<int> ptu_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  // A count beyond any unit's is a slip of the other side, not a place.
  constexpr int most = 10'000'000;
  return number_from(text, -most, most);
}

std::string PtuAxisCommand::say(std::string_view before, double value, std::string_view after) const {
  if (!unit_.modes.verbose) return fmt::format("* {}", value);
  const std::string sentence = fmt::format(fmt::runtime(before), channel_.name);
  return fmt::format("* {} {}{}", sentence, value, after);
}

std::string PtuAxisCommand::query(char what) const {
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
      return say("Target {} speed is", unit_.pure_velocity ? channel_.velocity : speeds.speed, " positions/sec");
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

std::string PtuAxisCommand::refusal_of_place(int target) const {
  if (target > unit_.high(channel_)) {
    return fmt::format("! Maximum allowable {} position is {}", channel_.name, unit_.high(channel_));
  }
  if (target < unit_.low(channel_)) {
    return fmt::format("! Minimum allowable {} position is {}", channel_.name, unit_.low(channel_));
  }
  return {};
}

std::string PtuAxisCommand::refusal_of_speed(int speed) const {
  const PtuSpeeds& speeds = axis_.speeds();
  if (speed > speeds.upper) {
    return fmt::format("! {} speed cannot exceed {} positions/sec", channel_.name, speeds.upper);
  }
  if (speed < speeds.lower) {
    return fmt::format("! {} speed cannot be less than {} positions/sec", channel_.name, speeds.lower);
  }
  return {};
}

std::string PtuAxisCommand::go(int target) {
  std::string refusal = refusal_of_place(target);
  if (!refusal.empty()) return refusal;
  channel_.awaited = target;
  if (unit_.modes.immediate) axis_.go_to(target);
  return "*";
}

std::string PtuAxisCommand::set_speed(int value) {
  if (unit_.pure_velocity) return set_velocity(value);
  std::string refusal = refusal_of_speed(value);
  if (!refusal.empty()) return refusal;
  axis_.speeds().speed = value;
  return "*";
}

// The sign says which way; one that is too slow halts the axis.
std::string PtuAxisCommand::set_velocity(int value) {
  const int size = std::abs(value);
  const bool halts = size < axis_.speeds().lower;
  std::string refusal = halts ? std::string() : refusal_of_speed(size);
  if (!refusal.empty()) return refusal;
  channel_.velocity = halts ? 0 : value;
  if (halts) {
    axis_.halt();
  } else {
    axis_.speeds().speed = size;
    axis_.go_to(value < 0 ? unit_.low(channel_) : unit_.high(channel_));
  }
  channel_.awaited = axis_.target();
  return "*";
}

// Asked for, or set within the unit's own.
std::string PtuAxisCommand::user_limit(char which, std::string_view argument) {
  int& limit = which == 'N' ? channel_.user_low : channel_.user_high;
  if (argument.empty()) return say(which == 'N' ? "Minimum {} position is" : "Maximum {} position is", limit);
  const std::optional<int> value = ptu_number(argument);
  if (!value || *value < axis_.model().low || *value > axis_.model().high) return std::string(illegal_argument);
  limit = *value;
  return "*";
}

std::string PtuAxisCommand::set(char what, int value) {
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
      return set_speed((unit_.pure_velocity ? channel_.velocity : speeds.speed) + value);
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

std::string PtuAxisCommand::power(std::string_view& mode, bool holding, std::string_view argument) const {
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

std::string PtuAxisCommand::obey(std::string_view words) {
  const char what = words.front();
  const std::string_view argument = words.substr(1);
  if ((what == 'N' || what == 'X') && argument.starts_with('U')) return user_limit(what, argument.substr(1));
  if (what == 'H') return power(channel_.hold, true, argument);
  if (what == 'M') return power(channel_.move, false, argument);
  if (argument.empty()) return query(what);
  const std::optional<int> value = ptu_number(argument);
  return value ? set(what, *value) : std::string(illegal_argument);
}

}  // namespace pizarra::simulation
