#pragma once

// The messages that a Universal Robots controller sends unasked at its client interfaces. The primary one (30001) sends
// packages of its state and messages about programs; the secondary one (30002) the state alone; the real-time one
// (30003) one packet of fixed layout. Big-endian; an e-Series with PolyScope 5.11.
//
//   port.write(ur_version_message(now_us));            // to a new client
//   port.write(ur_state_message(model, state));        // ten times a second
//   port.write(ur_real_time_packet(state));            // 500 times a second
//
// Currents, voltages, temperatures and forces, of which the emulated arm has no model, are told as 0. Facts from: the
// maker's client interface tables; its C++ client library reads what is written here.

#include "drivers/arm/arm_model.hpp"
#include "drivers/simulation/controllers/arms/ur_fields.hpp"

namespace pizarra::simulation {

inline constexpr std::size_t ur_real_time_octets = 1220;

std::string ur_state_message(const arm::ArmModel& model, const UrState& state);
std::string ur_real_time_packet(const UrState& state);

// Messages; `at_us` is the controller's time.
std::string ur_version_message(std::uint64_t at_us);
std::string ur_key_message(std::uint64_t at_us, std::string_view title, std::string_view text);
std::string ur_text_message(std::uint64_t at_us, std::string_view text);
// A program that went wrong, in which line of it.
std::string ur_exception_message(std::uint64_t at_us, std::int32_t line, std::string_view text);
// A code of the maker's list, such as 210: the interface takes no programs now.
std::string ur_error_message(std::uint64_t at_us, std::int32_t code);

}  // namespace pizarra::simulation
