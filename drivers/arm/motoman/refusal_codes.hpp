#pragma once

// Why a Motoman controller refuses something: codes that all of its servers share, four digits that the binary protocol
// writes as a hexadecimal number and the others as text.
//
//   refusal == motoman::servo_off            // 0x2070, "2070"
//
// Facts from: Yaskawa's manuals, by way of public clients.

#include <cstdint>

namespace pizarra::arm::motoman {

inline constexpr std::uint16_t operating = 0x2010;
inline constexpr std::uint16_t pendant_hold = 0x2020;
inline constexpr std::uint16_t external_hold = 0x2040;
inline constexpr std::uint16_t command_hold = 0x2050;
inline constexpr std::uint16_t alarm_occurring = 0x2060;
inline constexpr std::uint16_t servo_off = 0x2070;
inline constexpr std::uint16_t not_remote = 0x2100;
inline constexpr std::uint16_t servo_refused = 0x3450;

// Of commands in text.
inline constexpr std::uint16_t unknown_command = 0x1010;
inline constexpr std::uint16_t wrong_count = 0x1011;
inline constexpr std::uint16_t wrong_value = 0x1012;
inline constexpr std::uint16_t wrong_length = 0x1013;
inline constexpr std::uint16_t out_of_range = 0x5200;

}  // namespace pizarra::arm::motoman
