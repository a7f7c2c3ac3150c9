#pragma once

// The messages of Universal Robots' Real-Time Data Exchange (TCP port 30004): `u16 size, u8 type`, big-endian.
//
//   wire.write(rtde::write('V', rtde::version_2));
//   const Result<std::string> message = co_await frames.next(deadline);   // its type, then what it says
//
// Facts from: Universal Robots, Real-Time Data Exchange (RTDE) guide.

#include <array>

#include "drivers/line/frames.hpp"
#include "drivers/line/octets.hpp"

namespace pizarra::arm::rtde {

inline constexpr std::uint16_t port = 30004;
inline constexpr std::uint16_t script_port = 30002;
inline constexpr std::uint16_t dashboard_port = 29999;

inline constexpr char version = 'V';
inline constexpr char outputs = 'O';
inline constexpr char inputs = 'I';
inline constexpr char start = 'S';
inline constexpr char data = 'U';
inline constexpr char text = 'M';

inline constexpr std::int32_t running_mode = 7;
inline constexpr std::uint32_t playing = 2;

// The variables that the driver asks for, and the types that they must have.
inline constexpr std::string_view state_names =
    "actual_q,robot_mode,safety_mode,runtime_state,output_int_register_24,output_int_register_25,"
    "output_double_register_24";
inline constexpr std::string_view state_types = "VECTOR6D,INT32,INT32,UINT32,INT32,INT32,DOUBLE";
inline constexpr std::string_view opening_name = "input_double_register_24";

std::string write(char type, std::string_view payload);
// For Frames.
Result<std::optional<line::Frame>> frame(std::string_view octets);

struct State {
  std::array<double, 6> joints_rad{};
  std::int32_t robot_mode = 0;
  std::int32_t safety_mode = 0;
  std::uint32_t runtime = 0;
  std::int32_t marker = 0;   // int register 24: which program has begun or ended
  std::int32_t fingers = 0;  // int register 25: 1 while they move
  double opening_mm = 0;     // double register 24
};
// With the recipe's number before it. Failure: bad-reply, also where a number is not finite (with the axis).
Result<State> read_state(std::string_view payload);

}  // namespace pizarra::arm::rtde
