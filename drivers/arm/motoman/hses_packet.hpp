#pragma once

// The datagrams of Yaskawa's High Speed Ethernet Server, written and taken apart: a header of 32 octets, then data, all
// little-endian.
//
//   write_hses({.id = 7, .command = hses::status, .instance = 1, .attribute = 0, .service = hses::get_all})
//   read_hses_reply(datagram)     // its id, status and data
//
// Facts from: Yaskawa, FS100 options instructions for High-Speed Ethernet Server function (160766), by way of public
// clients. The length of the data as the header states it must be the datagram's.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra::arm {

namespace hses {

// Commands.
inline constexpr std::uint16_t alarm = 0x70;
inline constexpr std::uint16_t status = 0x72;
inline constexpr std::uint16_t position = 0x75;
inline constexpr std::uint16_t double_integer = 0x7c;  // D variables
inline constexpr std::uint16_t reset = 0x82;
inline constexpr std::uint16_t power = 0x83;
inline constexpr std::uint16_t move_cartesian = 0x8a;
inline constexpr std::uint16_t move_pulses = 0x8b;

// Services.
inline constexpr std::uint8_t get_all = 0x01;
inline constexpr std::uint8_t set_all = 0x02;
inline constexpr std::uint8_t get_one = 0x0e;
inline constexpr std::uint8_t set_one = 0x10;
inline constexpr std::uint8_t answered = 0x80;  // added to the service by whoever answers

// Instances.
inline constexpr std::uint16_t robot_pulses = 1;
inline constexpr std::uint16_t robot_base = 101;
inline constexpr std::uint16_t joint_move = 1;
inline constexpr std::uint16_t linear_move = 2;
inline constexpr std::uint16_t reset_alarm = 1;
inline constexpr std::uint16_t cancel_error = 2;
inline constexpr std::uint16_t hold = 1;
inline constexpr std::uint16_t servo = 2;

// Data.
inline constexpr std::uint32_t on = 1;
inline constexpr std::uint32_t off = 2;
inline constexpr std::uint32_t percent = 0;      // speed classes: 0.01 % ...
inline constexpr std::uint32_t millimetres = 1;  // ... and 0.1 mm/s
inline constexpr std::uint32_t base_frame = 16;

// Added status: why a request was refused, besides what refusal_codes.hpp has.
inline constexpr std::uint16_t undefined_command = 0xa000;
inline constexpr std::uint16_t wrong_instance = 0xa001;
inline constexpr std::uint16_t wrong_attribute = 0xa002;
inline constexpr std::uint16_t wrong_size = 0xb003;
inline constexpr std::uint16_t out_of_range = 0xb004;
inline constexpr std::uint16_t wrong_speed = 0xb009;
inline constexpr std::uint16_t wrong_frame = 0xb00b;

inline constexpr std::uint16_t port = 10040;

}  // namespace hses

struct HsesRequest {
  std::uint8_t id = 0;
  std::uint16_t command = 0;
  std::uint16_t instance = 0;
  std::uint8_t attribute = 0;
  std::uint8_t service = 0;
  std::string data = {};
};

struct HsesReply {
  std::uint8_t id = 0;
  std::uint8_t service = 0;
  std::uint8_t status = 0;  // 0: carried out
  std::uint16_t added_status = 0;
  std::string data = {};
};

std::string write_hses(const HsesRequest& request);
std::string write_hses(const HsesReply& reply);
// Failure: bad-message, which says what is wrong with it.
Result<HsesRequest> read_hses_request(std::string_view datagram);
Result<HsesReply> read_hses_reply(std::string_view datagram);
// The id of a reply; none where the datagram is none.
std::optional<std::uint32_t> hses_reply_id(std::string_view datagram);

}  // namespace pizarra::arm
