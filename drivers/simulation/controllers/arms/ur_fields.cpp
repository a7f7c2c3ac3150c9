#include "drivers/simulation/controllers/arms/ur_fields.hpp"

#include <algorithm>
#include <span>

#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

namespace {

struct Field {
  std::string_view name;
  UrType type;
};

constexpr Field outputs[] = {
    {"timestamp", UrType::f64},
    {"target_q", UrType::vector6},
    {"target_qd", UrType::vector6},
    {"target_qdd", UrType::vector6},
    {"target_current", UrType::vector6},
    {"target_moment", UrType::vector6},
    {"actual_q", UrType::vector6},
    {"actual_qd", UrType::vector6},
    {"actual_current", UrType::vector6},
    {"joint_control_output", UrType::vector6},
    {"actual_TCP_pose", UrType::vector6},
    {"actual_TCP_speed", UrType::vector6},
    {"actual_TCP_force", UrType::vector6},
    {"target_TCP_pose", UrType::vector6},
    {"target_TCP_speed", UrType::vector6},
    {"actual_digital_input_bits", UrType::u64},
    {"actual_digital_output_bits", UrType::u64},
    {"joint_temperatures", UrType::vector6},
    {"actual_execution_time", UrType::f64},
    {"robot_mode", UrType::i32},
    {"joint_mode", UrType::vector6_i32},
    {"safety_mode", UrType::i32},
    {"safety_status", UrType::i32},
    {"robot_status_bits", UrType::u32},
    {"safety_status_bits", UrType::u32},
    {"actual_tool_accelerometer", UrType::vector3},
    {"speed_scaling", UrType::f64},
    {"target_speed_fraction", UrType::f64},
    {"actual_momentum", UrType::f64},
    {"actual_main_voltage", UrType::f64},
    {"actual_robot_voltage", UrType::f64},
    {"actual_robot_current", UrType::f64},
    {"actual_joint_voltage", UrType::vector6},
    {"joint_position_deviation_ratio", UrType::f64},
    {"runtime_state", UrType::u32},
    {"elbow_position", UrType::vector3},
    {"elbow_velocity", UrType::vector3},
    {"standard_analog_input0", UrType::f64},
    {"standard_analog_input1", UrType::f64},
    {"standard_analog_output0", UrType::f64},
    {"standard_analog_output1", UrType::f64},
    {"analog_io_types", UrType::u32},
    {"io_current", UrType::f64},
    {"tool_mode", UrType::u32},
    {"tool_analog_input_types", UrType::u32},
    {"tool_analog_input0", UrType::f64},
    {"tool_analog_input1", UrType::f64},
    {"tool_output_voltage", UrType::i32},
    {"tool_output_current", UrType::f64},
    {"tool_temperature", UrType::f64},
    {"tcp_force_scalar", UrType::f64},
    {"tcp_offset", UrType::vector6},
    {"ft_raw_wrench", UrType::vector6},
    {"payload", UrType::f64},
    {"payload_cog", UrType::vector3},
    {"payload_inertia", UrType::vector6},
    {"script_control_line", UrType::u32},
    {"output_bit_registers0_to_31", UrType::u32},
    {"output_bit_registers32_to_63", UrType::u32},
    {"input_bit_registers0_to_31", UrType::u32},
    {"input_bit_registers32_to_63", UrType::u32},
};

constexpr Field inputs[] = {
    {"speed_slider_mask", UrType::u32},           {"speed_slider_fraction", UrType::f64},
    {"standard_digital_output_mask", UrType::u8}, {"configurable_digital_output_mask", UrType::u8},
    {"tool_digital_output_mask", UrType::u8},     {"standard_digital_output", UrType::u8},
    {"configurable_digital_output", UrType::u8},  {"tool_digital_output", UrType::u8},
    {"standard_analog_output_mask", UrType::u8},  {"standard_analog_output_type", UrType::u8},
    {"standard_analog_output_0", UrType::f64},    {"standard_analog_output_1", UrType::f64},
    {"input_bit_registers0_to_31", UrType::u32},  {"input_bit_registers32_to_63", UrType::u32},
    {"external_force_torque", UrType::vector6},
};

std::optional<UrType> type_among(std::span<const Field> fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name, &Field::name);
  return found == fields.end() ? std::nullopt : std::optional(found->type);
}

// Of a register of this side: KIND_register_NUMBER.
std::optional<UrType> register_type(std::string_view name, std::string_view side) {
  if (!name.starts_with(side)) return std::nullopt;
  name.remove_prefix(side.size());
  struct Kind {
    std::string_view prefix;
    UrType type;
    int first;
    int last;
  };
  constexpr Kind kinds[] = {{"int_register_", UrType::i32, 0, 47},
                            {"double_register_", UrType::f64, 0, 47},
                            {"bit_register_", UrType::boolean, 64, 127}};
  for (const Kind& kind : kinds) {
    if (!name.starts_with(kind.prefix)) continue;
    const bool known = number_from(name.substr(kind.prefix.size()), kind.first, kind.last).has_value();
    return known ? std::optional(kind.type) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<UrType> ur_output_type(std::string_view name) {
  if (const auto type = type_among(outputs, name)) return type;
  if (const auto type = register_type(name, "output_")) return type;
  return register_type(name, "input_");
}

std::optional<UrType> ur_input_type(std::string_view name) {
  if (const auto type = type_among(inputs, name)) return type;
  return register_type(name, "input_");
}

std::string_view ur_type_name(UrType type) {
  constexpr std::string_view names[] = {"DOUBLE", "VECTOR6D", "VECTOR3D", "VECTOR6INT32", "INT32",
                                        "UINT32", "UINT64",   "UINT8",    "BOOL"};
  return names[static_cast<std::size_t>(type)];
}

UrValue UrState::value(std::string_view name) const {
  if (name == "actual_q" || name == "target_q") return joints_rad;
  if (name == "actual_qd" || name == "target_qd") return joints_rad_s;
  if (name == "actual_TCP_pose" || name == "target_TCP_pose") return tool;
  if (name == "joint_mode") return {joint_mode, joint_mode, joint_mode, joint_mode, joint_mode, joint_mode};
  const auto found = numbers.find(name);
  return {found == numbers.end() ? 0 : found->second};
}

void write_ur_value(line::OctetWriter& octets, UrType type, const UrValue& value) {
  const double number = value.front();
  switch (type) {
    case UrType::f64:
      octets.f64(number);
      return;
    case UrType::vector6:
      for (const double each : value) octets.f64(each);
      return;
    case UrType::vector3:
      for (std::size_t i = 0; i < 3; ++i) octets.f64(value[i]);
      return;
    case UrType::vector6_i32:
      for (const double each : value) octets.i32(static_cast<std::int32_t>(each));
      return;
    case UrType::i32:
      octets.i32(static_cast<std::int32_t>(number));
      return;
    case UrType::u32:
      octets.u32(static_cast<std::uint32_t>(number));
      return;
    case UrType::u64:
      octets.u32(0).u32(static_cast<std::uint32_t>(number));
      return;
    case UrType::u8:
    case UrType::boolean:
      octets.u8(static_cast<std::uint8_t>(number));
      return;
  }
}

double read_ur_number(line::OctetReader& read, UrType type) {
  if (type == UrType::f64) return read.f64();
  if (type == UrType::vector6) {
    const double first = read.f64();
    read.text(5 * sizeof(double));
    return first;
  }
  if (type == UrType::i32) return read.i32();
  if (type == UrType::u32) return read.u32();
  return read.u8();
}

}  // namespace pizarra::simulation
