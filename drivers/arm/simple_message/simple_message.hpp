#pragma once

// The messages of ROS-Industrial's simple_message: type, kind, reply code and data, each 4 octets; numbers are little-
// or big-endian, as the controller's are. Over TCP a length goes before them; over the CRS C500C's serial lines a mark,
// a sum and a length, so that a garbled one is passed over.
//
//   write_simple({.type = simple::ping, .kind = simple::request}, ByteOrder::little)     // without what goes before
//   tcp_frame(message, ByteOrder::little)        serial_frame(message)
//   Frames frames(wire, frame_of_tcp_little);    Frames frames(wire, frame_of_serial);
//
// Facts from: ROS-Industrial REP I0004 and the servers of crs-c500c-utils, which run on the C500C.

#include <array>

#include "drivers/arm/arm_model.hpp"
#include "drivers/line/frames.hpp"
#include "drivers/line/octets.hpp"

namespace pizarra::arm {

namespace simple {

inline constexpr std::int32_t ping = 1;
inline constexpr std::int32_t joint_position = 10;
inline constexpr std::int32_t trajectory_point = 11;
inline constexpr std::int32_t status = 13;

inline constexpr std::int32_t topic = 1;
inline constexpr std::int32_t request = 2;
inline constexpr std::int32_t reply = 3;

inline constexpr std::int32_t success = 1;
inline constexpr std::int32_t failure = 2;

inline constexpr std::int32_t stop_trajectory = -4;  // in place of a sequence number
inline constexpr std::int32_t nobodys_number = -9;   // at which the C500C's servers abort the robot

inline constexpr std::uint16_t motion_port = 11000;
inline constexpr std::uint16_t state_port = 11002;
inline constexpr std::size_t axes = 10;

}  // namespace simple

struct SimpleMessage {
  std::int32_t type = 0;
  std::int32_t kind = 0;
  std::int32_t code = 0;
  std::string data = {};
};

using SimpleJoints = std::array<float, simple::axes>;

struct SimplePosition {
  std::int32_t sequence = 0;
  SimpleJoints joints_rad{};
};

struct SimplePoint {
  std::int32_t sequence = 0;
  SimpleJoints joints_rad{};
  float velocity = 0;  // part of the axes' speeds, 0..1
  float duration_s = 0;
};

// -1 where the controller does not know.
struct SimpleStatus {
  std::int32_t drives_powered = -1;
  std::int32_t emergency_stopped = -1;
  std::int32_t error_code = 0;
  std::int32_t in_error = 0;
  std::int32_t in_motion = 0;
  std::int32_t mode = -1;  // 1 manual, 2 automatic
  std::int32_t motion_possible = -1;
};

std::string write_simple(const SimpleMessage& message, line::ByteOrder order);
// Failures of all of these: bad-reply; of numbers that are not finite, with the axis.
Result<SimpleMessage> read_simple(std::string_view octets, line::ByteOrder order);

std::string write_position(const SimplePosition& position, line::ByteOrder order);
Result<SimplePosition> read_position(std::string_view data, line::ByteOrder order);
std::string write_point(const SimplePoint& point, line::ByteOrder order);
Result<SimplePoint> read_point(std::string_view data, line::ByteOrder order);
std::string write_status(const SimpleStatus& status, line::ByteOrder order);
Result<SimpleStatus> read_status(std::string_view data, line::ByteOrder order);
// The reason for which the arm cannot move, beside `motion_possible`. Failure: not-in-control; an error's code is its
// subject.
Result<void> check_status(const SimpleStatus& status);

// An axis' reading, degrees or mm, and the joint that it is on the wire, radians or metres; `sign` is of angles.
float joint_of_axis(Role role, double reading, double sign);
double axis_of_joint(Role role, float joint, double sign);

std::string tcp_frame(std::string_view message, line::ByteOrder order);
std::string serial_frame(std::string_view message);
// For Frames. On a serial line, octets that do not begin with a mark and frames with a wrong sum are passed over. A
// length that no message has ends a TCP line.
Result<std::optional<line::Frame>> frame_of_tcp_little(std::string_view octets);
Result<std::optional<line::Frame>> frame_of_tcp_big(std::string_view octets);
Result<std::optional<line::Frame>> frame_of_serial(std::string_view octets);

}  // namespace pizarra::arm
