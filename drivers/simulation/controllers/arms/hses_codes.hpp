#pragma once

// The codes of the High Speed Ethernet Server that the driver does not use: further commands, services and refusals.
//
//   outcome.refusal = hses_code(refusal);

#include <cstdint>

#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

namespace hses {

inline constexpr std::uint16_t alarm_history = 0x71;
inline constexpr std::uint16_t executing_job = 0x73;
inline constexpr std::uint16_t axis_names = 0x74;
inline constexpr std::uint16_t position_error = 0x76;
inline constexpr std::uint16_t torque = 0x77;
inline constexpr std::uint16_t network_io = 0x78;
inline constexpr std::uint16_t cycle = 0x84;
inline constexpr std::uint16_t pendant_text = 0x85;
inline constexpr std::uint16_t start_job = 0x86;
inline constexpr std::uint16_t select_job = 0x87;
inline constexpr std::uint16_t management_time = 0x88;
inline constexpr std::uint16_t system_information = 0x89;
inline constexpr std::uint16_t plural = 0x288;  // added to a variable's command: several, one after another

inline constexpr std::uint8_t get_several = 0x33;
inline constexpr std::uint8_t set_several = 0x34;
inline constexpr std::uint16_t interlock = 3;  // instance of 0x83
inline constexpr std::uint16_t incremental_move = 3;
inline constexpr std::uint32_t robot_frame = 17;
inline constexpr std::uint32_t tool_frame = 19;

inline constexpr std::uint16_t job_not_found = 0x4040;
inline constexpr std::uint16_t wrong_instruction = 0x5110;
inline constexpr std::uint16_t not_to_be_set = 0xb002;

}  // namespace hses

inline std::uint16_t hses_code(Refusal refusal) {
  constexpr std::uint16_t out_of_range = 0xb004;
  return refusal == Refusal::out_of_range ? out_of_range : motoman_code(refusal);
}

}  // namespace pizarra::simulation
