#include "drivers/simulation/controllers/arms/ur_interface.hpp"

#include <numbers>

#include "lisp/numbers.hpp"

namespace pizarra::simulation {

namespace {

using Octets = line::OctetWriter;

constexpr std::uint8_t state_type = 16;
constexpr std::uint8_t message_type = 20;
constexpr std::uint8_t robot_control_loop = 0xfe;  // who says a message: the controller itself
constexpr std::int32_t ur5 = 1;                    // robot types; an e-Series is told by its version
constexpr std::size_t joint_count = 6;
constexpr std::size_t electrical = 16;  // current, voltage and two temperatures

Octets big_endian() { return Octets(line::ByteOrder::big); }

Octets& u64(Octets& to, std::uint64_t value) {
  return to.u32(static_cast<std::uint32_t>(value >> 32)).u32(static_cast<std::uint32_t>(value));
}

void put_all(Octets& to, const UrValue& values) {
  for (const double value : values) to.f64(value);
}

double told(const UrState& state, std::string_view name) { return state.value(name).front(); }

std::uint8_t bit_of(bool value) { return value ? 1 : 0; }

// A package of the state: its size, its type, what it says.
std::string state_package(std::uint8_t type, const Octets& says) {
  Octets whole = big_endian();
  constexpr std::size_t head = 5;
  return whole.u32(static_cast<std::uint32_t>(head + says.octets().size())).u8(type).text(says.octets()).octets();
}

std::string mode_package(const UrState& state) {
  constexpr std::int32_t running = 7;
  constexpr std::int32_t idle = 5;
  constexpr std::uint32_t playing = 2;
  constexpr std::uint32_t paused = 4;
  const auto mode = static_cast<std::int32_t>(told(state, "robot_mode"));
  const auto safety = static_cast<std::int32_t>(told(state, "safety_mode"));
  const auto runtime = static_cast<std::uint32_t>(told(state, "runtime_state"));
  constexpr std::int32_t protective = 3;
  constexpr std::int32_t emergency = 7;
  constexpr std::uint8_t position_mode = 0;
  Octets says = big_endian();
  u64(says, static_cast<std::uint64_t>(told(state, "timestamp") * 1e6));
  says.u8(1).u8(1).u8(bit_of(mode == running || mode == idle)).u8(bit_of(safety == emergency));
  says.u8(bit_of(safety == protective)).u8(bit_of(runtime == playing)).u8(bit_of(runtime == paused));
  says.u8(static_cast<std::uint8_t>(mode)).u8(position_mode);
  says.f64(told(state, "target_speed_fraction")).f64(told(state, "speed_scaling")).f64(1).u8(0);
  return state_package(0, says);
}

std::string joint_package(const UrState& state) {
  Octets says = big_endian();
  for (std::size_t joint = 0; joint < joint_count; ++joint) {
    says.f64(state.joints_rad[joint]).f64(state.joints_rad[joint]).f64(state.joints_rad_s[joint]).zeros(electrical);
    says.u8(static_cast<std::uint8_t>(state.joint_mode));
  }
  return state_package(1, says);
}

std::string tool_package() {
  constexpr std::size_t all_but_mode = 31;
  constexpr std::uint8_t idle = 255;
  Octets says = big_endian();
  return state_package(2, says.zeros(all_but_mode).u8(idle));
}

std::string masterboard_package(const UrState& state) {
  constexpr std::size_t analog = 2 + 16 + 2 + 16;
  Octets says = big_endian();
  says.u32(0).u32(static_cast<std::uint32_t>(told(state, "actual_digital_output_bits"))).zeros(analog + electrical);
  says.u8(static_cast<std::uint8_t>(told(state, "safety_mode"))).u8(0).u8(0).u32(0).u8(0).u8(1).u8(0);
  return state_package(3, says);
}

std::string place_package(const UrState& state) {
  Octets says = big_endian();
  put_all(says, state.tool);
  put_all(says, {});
  return state_package(4, says);
}

// Denavit and Hartenberg's parameters, m and rad.
struct Parameters {
  UrValue theta{}, a{}, d{}, alpha{};
};

Parameters parameters_of(const arm::ArmModel& model) {
  constexpr double mm = 1e-3;
  constexpr double right = std::numbers::pi / 2;
  Parameters dh;
  dh.a = {0, -model.upper_arm_mm * mm, -model.forearm_mm * mm, 0, 0, 0};
  dh.d = {model.height_mm * mm, 0, 0, model.side_mm * mm, model.wrist_across_mm * mm, model.wrist_mm * mm};
  dh.alpha = {right, 0, 0, right, -right, 0};
  return dh;
}

std::string kinematics_package(const arm::ArmModel& model) {
  constexpr std::uint32_t linearized = 2;  // calibrated
  const Parameters dh = parameters_of(model);
  Octets says = big_endian();
  for (std::size_t joint = 0; joint < joint_count; ++joint) says.u32(0);
  for (const UrValue* values : {&dh.theta, &dh.a, &dh.d, &dh.alpha}) put_all(says, *values);
  return state_package(5, says.u32(linearized));
}

std::string configuration_package(const arm::ArmModel& model) {
  constexpr double farthest = 2 * std::numbers::pi;
  constexpr double acceleration = 40;
  const Parameters dh = parameters_of(model);
  Octets says = big_endian();
  for (std::size_t joint = 0; joint < joint_count; ++joint) says.f64(-farthest).f64(farthest);
  for (std::size_t joint = 0; joint < joint_count; ++joint) {
    const std::size_t axis = joint < 4 ? joint : 4;  // wrist 2 has none; it is told as wrist 3
    says.f64(radians(model.axes[axis].speed)).f64(acceleration);
  }
  says.f64(1.05).f64(1.4).f64(0.25).f64(1.2).f64(0.13);  // what moves go at where they do not say; the tool's radius
  for (const UrValue* values : {&dh.a, &dh.d, &dh.alpha, &dh.theta}) put_all(says, *values);
  return state_package(6, says.i32(0).i32(3).i32(ur5).i32(0));
}

std::string other_packages() {
  struct Empty {
    std::uint8_t type;
    std::size_t octets;
  };
  constexpr Empty empty[] = {{7, 56}, {8, 4}, {11, 21}, {12, 3}};  // force mode, further, the tool's line and outputs
  std::string all;
  for (const Empty& each : empty) all += state_package(each.type, big_endian().zeros(each.octets));
  return all;
}

std::string in_frame(std::uint8_t type, std::string_view says) {
  constexpr std::size_t head = 5;
  Octets whole = big_endian();
  return whole.u32(static_cast<std::uint32_t>(head + says.size())).u8(type).text(says).octets();
}

std::string message_of(std::uint64_t at_us, std::uint8_t kind, const Octets& says) {
  Octets whole = big_endian();
  u64(whole, at_us).u8(robot_control_loop).u8(kind).text(says.octets());
  return in_frame(message_type, whole.octets());
}

Octets text_after_size(Octets to, std::string_view text) {
  return to.u8(static_cast<std::uint8_t>(text.size())).text(text);
}

}  // namespace

std::string ur_state_message(const arm::ArmModel& model, const UrState& state) {
  return in_frame(state_type, mode_package(state) + joint_package(state) + tool_package() + masterboard_package(state) +
                                  place_package(state) + kinematics_package(model) + configuration_package(model) +
                                  other_packages());
}

std::string ur_real_time_packet(const UrState& state) {
  constexpr std::size_t one = 8;
  constexpr std::size_t six = 48;
  const double joint_mode = state.joint_mode;
  Octets packet = big_endian();
  packet.u32(ur_real_time_octets).f64(told(state, "timestamp"));
  put_all(packet, state.joints_rad);  // targets: place, speed; acceleration, current, moment
  put_all(packet, state.joints_rad_s);
  packet.zeros(3 * six);
  put_all(packet, state.joints_rad);  // actual: place, speed; current, and that of control
  put_all(packet, state.joints_rad_s);
  packet.zeros(2 * six);
  put_all(packet, state.tool);  // place; speed and force
  packet.zeros(2 * six);
  put_all(packet, state.tool);  // the same as targets, the digital inputs, the motors' temperatures
  packet.zeros(six + one + six);
  packet.zeros(2 * one).f64(told(state, "robot_mode"));  // after the controller's timer and a test's value
  for (std::size_t joint = 0; joint < joint_count; ++joint) packet.f64(joint_mode);
  packet.f64(told(state, "safety_mode")).zeros(six + 3 * one + six).f64(told(state, "speed_scaling"));
  packet.zeros(one + 2 * one + 3 * one + six);  // momentum, nothing, voltages and current
  packet.f64(told(state, "actual_digital_output_bits")).f64(told(state, "runtime_state"));
  packet.zeros(six).f64(told(state, "safety_status")).zeros(3 * one + one + 3 * one + six);  // elbow; nothing; load
  return packet.octets();
}

std::string ur_version_message(std::uint64_t at_us) {
  constexpr std::uint8_t kind = 3;
  Octets says = text_after_size(big_endian(), "URControl");
  return message_of(at_us, kind, says.u8(5).u8(11).u32(0).u32(108249).text("01-01-2021, 00:00:00"));
}

std::string ur_key_message(std::uint64_t at_us, std::string_view title, std::string_view text) {
  constexpr std::uint8_t kind = 7;
  Octets says = text_after_size(big_endian().u32(0).u32(0), title);
  return message_of(at_us, kind, says.text(text));
}

std::string ur_text_message(std::uint64_t at_us, std::string_view text) {
  constexpr std::uint8_t kind = 0;
  return message_of(at_us, kind, big_endian().text(text));
}

std::string ur_exception_message(std::uint64_t at_us, std::int32_t line, std::string_view text) {
  constexpr std::uint8_t kind = 10;
  return message_of(at_us, kind, big_endian().i32(line).i32(1).text(text));
}

std::string ur_error_message(std::uint64_t at_us, std::int32_t code) {
  constexpr std::uint8_t kind = 6;
  constexpr std::int32_t warning = 2;
  return message_of(at_us, kind, big_endian().i32(code).i32(0).i32(warning).u32(0).u32(0));
}

}  // namespace pizarra::simulation
