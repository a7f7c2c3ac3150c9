#include "drivers/arm/simple_message/simple_message.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "lisp/numbers.hpp"

namespace pizarra::arm {

namespace {

constexpr double mm_per_m = 1000;

constexpr std::size_t head = 12;
constexpr std::size_t longest_message = 1024;
constexpr std::string_view mark = "\xff\xff\xfe";

std::unexpected<Failure> wrong_size(const char* what, std::size_t octets) {
  return fail("bad-reply", fmt::format("the controller sent {} of {} octets", what, octets));
}

Result<void> finite(const std::array<float, simple::axes>& joints) {
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    if (std::isfinite(joints[axis])) continue;
    return fail("bad-reply", fmt::format("the value for axis {} is not a number", axis + 1), to_datum(axis + 1));
  }
  return {};
}

Result<std::optional<line::Frame>> frame_of_tcp(std::string_view octets, line::ByteOrder order) {
  if (octets.size() < 4) return std::nullopt;
  const std::size_t length = line::OctetReader(octets, order).u32();
  if (length < head || length > longest_message) return fail("bad-reply", "this is no simple message");
  if (octets.size() < 4 + length) return std::nullopt;
  return line::Frame{4 + length, octets.substr(4, length)};
}

std::uint8_t sum_of(std::string_view message) {
  return static_cast<std::uint8_t>(std::accumulate(
      message.begin(), message.end(), 0u, [](unsigned sum, char c) { return sum + static_cast<unsigned char>(c); }));
}

}  // namespace

std::string write_simple(const SimpleMessage& message, line::ByteOrder order) {
  return line::OctetWriter(order).i32(message.type).i32(message.kind).i32(message.code).text(message.data).octets();
}

Result<SimpleMessage> read_simple(std::string_view octets, line::ByteOrder order) {
  line::OctetReader read(octets, order);
  SimpleMessage message;
  message.type = read.i32();
  message.kind = read.i32();
  message.code = read.i32();
  if (!read.sound()) return wrong_size("a message", octets.size());
  message.data = read.rest();
  return message;
}

std::string write_position(const SimplePosition& position, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(position.sequence);
  for (const float joint : position.joints_rad) data.f32(joint);
  return data.octets();
}

Result<SimplePosition> read_position(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  SimplePosition position;
  position.sequence = read.i32();
  for (float& joint : position.joints_rad) joint = read.f32();
  if (!read.whole()) return wrong_size("a position", data.size());
  const Result<void> sound = finite(position.joints_rad);
  if (!sound) return fail(sound);
  return position;
}

std::string write_point(const SimplePoint& point, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(point.sequence);
  for (const float joint : point.joints_rad) data.f32(joint);
  return data.f32(point.velocity).f32(point.duration_s).octets();
}

Result<SimplePoint> read_point(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  SimplePoint point;
  point.sequence = read.i32();
  for (float& joint : point.joints_rad) joint = read.f32();
  point.velocity = read.f32();
  point.duration_s = read.f32();
  if (!read.whole()) return wrong_size("a point", data.size());
  const Result<void> sound = finite(point.joints_rad);
  if (!sound) return fail(sound);
  if (!std::isfinite(point.velocity)) return fail("bad-reply", "the velocity is no number");
  return point;
}

std::string write_status(const SimpleStatus& status, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(status.drives_powered).i32(status.emergency_stopped).i32(status.error_code).i32(status.in_error);
  return data.i32(status.in_motion).i32(status.mode).i32(status.motion_possible).octets();
}

Result<SimpleStatus> read_status(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  SimpleStatus status;
  for (std::int32_t* field : {&status.drives_powered, &status.emergency_stopped, &status.error_code, &status.in_error,
                              &status.in_motion, &status.mode, &status.motion_possible}) {
    *field = read.i32();
  }
  if (!read.whole()) return wrong_size("a status", data.size());
  return status;
}

Result<void> check_status(const SimpleStatus& status) {
  if (status.emergency_stopped == 1) return fail("not-in-control", "the emergency stop is pressed");
  if (status.in_error == 1) return fail("not-in-control", "the controller has an error", to_datum(status.error_code));
  if (status.mode == 1) return fail("not-in-control", "the pendant has control: the controller is in manual mode");
  if (status.drives_powered == 0) return fail("not-in-control", "the arm's drives are off");
  return {};
}

float joint_of_axis(Role role, double reading, double sign) {
  return static_cast<float>(slides(role) ? reading / mm_per_m : sign * radians(reading));
}

double axis_of_joint(Role role, float joint, double sign) {
  const auto wide = static_cast<double>(joint);
  return slides(role) ? wide * mm_per_m : degrees(sign * wide);
}

std::string tcp_frame(std::string_view message, line::ByteOrder order) {
  return line::OctetWriter(order).u32(static_cast<std::uint32_t>(message.size())).text(message).octets();
}

std::string serial_frame(std::string_view message) {
  line::OctetWriter octets(line::ByteOrder::little);
  octets.text(mark).u8(sum_of(message)).u32(static_cast<std::uint32_t>(message.size()));
  return octets.text(message).octets();
}

Result<std::optional<line::Frame>> frame_of_tcp_little(std::string_view octets) {
  return frame_of_tcp(octets, line::ByteOrder::little);
}

Result<std::optional<line::Frame>> frame_of_tcp_big(std::string_view octets) {
  return frame_of_tcp(octets, line::ByteOrder::big);
}

Result<std::optional<line::Frame>> frame_of_serial(std::string_view octets) {
  for (std::size_t begin = octets.find(mark); begin != std::string_view::npos; begin = octets.find(mark, begin + 1)) {
    line::OctetReader read(octets.substr(begin + mark.size()), line::ByteOrder::little);
    const std::uint8_t sum = read.u8();
    const std::size_t length = read.u32();
    if (!read.sound()) return std::nullopt;
    if (length < head || length > longest_message) continue;
    const std::string_view message = read.text(length);
    if (!read.sound()) return std::nullopt;
    if (sum_of(message) != sum) continue;
    return line::Frame{octets.size() - read.left(), message};
  }
  return std::nullopt;
}

}  // namespace pizarra::arm
