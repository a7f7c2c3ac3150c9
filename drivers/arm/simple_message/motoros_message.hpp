#pragma once

// The messages that MotoROS adds to simple_message (simple_message.hpp): points of a trajectory with their moments and
// speeds, the state of a control group, and commands to the motion server, each answered with a result and a subcode.
//
//   SimpleMessage message{.type = motoros::motion_control, .kind = simple::request};
//   message.data = write_control({.command = motoros::start_trajectories}, order);
//   const Result<MotorosReply> reply = read_reply(answer.data, order);
//
// Facts from: MotoROS' own server, which is published with ROS-Industrial's driver for Motoman.

#include "drivers/arm/simple_message/simple_message.hpp"

namespace pizarra::arm {

namespace motoros {

inline constexpr std::int32_t trajectory_point = 14;
inline constexpr std::int32_t feedback = 15;
inline constexpr std::int32_t motion_control = 2001;
inline constexpr std::int32_t motion_reply = 2002;

inline constexpr std::int32_t check_ready = 200101;
inline constexpr std::int32_t check_queue = 200102;
inline constexpr std::int32_t stop_motion = 200111;
inline constexpr std::int32_t start_servos = 200112;
inline constexpr std::int32_t stop_servos = 200113;
inline constexpr std::int32_t reset_alarm = 200114;
inline constexpr std::int32_t start_trajectories = 200121;
inline constexpr std::int32_t stop_trajectories = 200122;
inline constexpr std::int32_t disconnect = 200130;

inline constexpr std::int32_t success = 0;
inline constexpr std::int32_t busy = 1;
inline constexpr std::int32_t failure = 2;
inline constexpr std::int32_t invalid = 3;
inline constexpr std::int32_t alarm = 4;
inline constexpr std::int32_t not_ready = 5;

// Subcodes: of what is invalid, and of why it is not ready.
inline constexpr std::int32_t invalid_message = 3003;
inline constexpr std::int32_t invalid_group = 3004;
inline constexpr std::int32_t invalid_sequence = 3005;
inline constexpr std::int32_t invalid_command = 3006;
inline constexpr std::int32_t invalid_start = 3011;
inline constexpr std::int32_t invalid_position = 3012;
inline constexpr std::int32_t invalid_speed = 3013;
inline constexpr std::int32_t insufficient_data = 3015;
inline constexpr std::int32_t unready_alarm = 5001;
inline constexpr std::int32_t unready_emergency = 5003;
inline constexpr std::int32_t unready_not_remote = 5005;
inline constexpr std::int32_t unready_servo_off = 5006;
inline constexpr std::int32_t unready_hold = 5007;
inline constexpr std::int32_t unready_not_started = 5008;

inline constexpr std::int32_t has_time = 1;
inline constexpr std::int32_t has_position = 2;
inline constexpr std::int32_t has_speed = 4;

inline constexpr std::uint16_t motion_port = 50240;
inline constexpr std::uint16_t state_port = 50241;

}  // namespace motoros

struct MotorosPoint {
  std::int32_t group = 0;
  std::int32_t sequence = 0;  // 0: where the arm stands
  std::int32_t has = motoros::has_time | motoros::has_position | motoros::has_speed;
  float time_s = 0;  // since the trajectory's begin
  SimpleJoints joints_rad{};
  SimpleJoints speeds_rad_s{};
};

struct MotorosFeedback {
  std::int32_t group = 0;
  std::int32_t has = motoros::has_position | motoros::has_speed;
  float time_s = 0;
  SimpleJoints joints_rad{};
  SimpleJoints speeds_rad_s{};
};

struct MotorosControl {
  std::int32_t group = 0;
  std::int32_t sequence = 0;  // comes back in the reply
  std::int32_t command = 0;
};

struct MotorosReply {
  std::int32_t group = 0;
  std::int32_t sequence = 0;
  std::int32_t command = 0;  // or the type of the message, of a point
  std::int32_t result = motoros::success;
  std::int32_t subcode = 0;
};

std::string write_motoros_point(const MotorosPoint& point, line::ByteOrder order);
std::string write_feedback(const MotorosFeedback& feedback, line::ByteOrder order);
std::string write_control(const MotorosControl& control, line::ByteOrder order);
std::string write_reply(const MotorosReply& reply, line::ByteOrder order);
// Failure of all of these: bad-reply; of numbers that are not finite, with the axis.
Result<MotorosPoint> read_motoros_point(std::string_view data, line::ByteOrder order);
Result<MotorosFeedback> read_feedback(std::string_view data, line::ByteOrder order);
Result<MotorosControl> read_control(std::string_view data, line::ByteOrder order);
Result<MotorosReply> read_reply(std::string_view data, line::ByteOrder order);

// A result and its subcode in words.
std::string_view meaning_of(const MotorosReply& reply);

}  // namespace pizarra::arm
