#pragma once

// One line of what a PTU says, taken apart.
//
//   read_ptu_line("PP * Current Pan position is 1000")    // echo "PP", result ok, text "Current Pan position is 1000"
//   read_ptu_line("R !T!T!P!P*")                          // echo "R", both axes hit their stops, result ok
//   read_ptu_line("! Maximum allowable Pan position is 3090")
//   read_ptu_line("!P")                                   // no result: only that pan has hit its stop

#include <optional>
#include <string>
#include <string_view>

namespace pizarra::ptu {

struct PtuLine {
  enum class Result : std::uint8_t { none, ok, error };
  std::string echo;
  bool pan_hit = false;
  bool tilt_hit = false;
  Result result = Result::none;
  std::string text;
};

PtuLine read_ptu_line(std::string_view line);

// The first number of a text, such as 185.1428 of "185.1428 seconds arc per position".
std::optional<double> first_number(std::string_view text);

}  // namespace pizarra::ptu
