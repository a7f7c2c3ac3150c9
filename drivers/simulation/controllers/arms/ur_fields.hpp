#pragma once

// The values of a Universal Robots arm that can be told and set by name over its data exchange, and their encoding.
//
//   ur_output_type("actual_q")                     // vector6
//   write_ur_value(octets, UrType::vector6, state.value("actual_q"));
//
// Values that the emulated arm has no model of (currents, moments, forces, voltages, temperatures) are told as 0.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/line/octets.hpp"

namespace pizarra::simulation {

enum class UrType : std::uint8_t { f64, vector6, vector3, vector6_i32, i32, u32, u64, u8, boolean };

// None of names that there are not.
std::optional<UrType> ur_output_type(std::string_view name);
std::optional<UrType> ur_input_type(std::string_view name);
std::string_view ur_type_name(UrType type);

using UrValue = std::array<double, 6>;  // a number is its first

struct UrState {
  UrValue joints_rad{};
  UrValue joints_rad_s{};
  UrValue tool{};  // place in m, rotation vector
  double joint_mode = 0;
  std::map<std::string, double, std::less<>> numbers = {};  // by name; 0 where there is none

  UrValue value(std::string_view name) const;
};

void write_ur_value(line::OctetWriter& octets, UrType type, const UrValue& value);
// The first, of several.
double read_ur_number(line::OctetReader& read, UrType type);

}  // namespace pizarra::simulation
