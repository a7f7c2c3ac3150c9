#include "drivers/arm/universal/rtde.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra::arm::rtde {

namespace {

constexpr std::size_t header = 3;

}  // namespace

std::string write(char type, std::string_view payload) {
  line::OctetWriter octets(line::ByteOrder::big);
  octets.u16(static_cast<std::uint16_t>(header + payload.size())).u8(static_cast<std::uint8_t>(type));
  return octets.text(payload).octets();
}

Result<std::optional<line::Frame>> frame(std::string_view octets) {
  if (octets.size() < header) return std::nullopt;
  const std::size_t size = line::OctetReader(octets, line::ByteOrder::big).u16();
  if (size < header) return fail("bad-reply", "this is no message of the Real-Time Data Exchange");
  if (octets.size() < size) return std::nullopt;
  return line::Frame{size, octets.substr(2, size - 2)};
}

Result<State> read_state(std::string_view payload) {
  line::OctetReader read(payload, line::ByteOrder::big);
  read.u8();
  State state;
  for (double& joint : state.joints_rad) joint = read.f64();
  state.robot_mode = read.i32();
  state.safety_mode = read.i32();
  state.runtime = read.u32();
  state.marker = read.i32();
  state.fingers = read.i32();
  state.opening_mm = read.f64();
  if (!read.whole()) return fail("bad-reply", fmt::format("the arm told its state in {} octets", payload.size()));
  for (std::size_t axis = 0; axis < state.joints_rad.size(); ++axis) {
    if (std::isfinite(state.joints_rad[axis])) continue;
    return fail("bad-reply", fmt::format("the arm's value of axis {} is not a number", axis + 1), to_datum(axis + 1));
  }
  if (!std::isfinite(state.opening_mm)) return fail("bad-reply", "the arm's value of its gripper is not a number");
  return state;
}

}  // namespace pizarra::arm::rtde
