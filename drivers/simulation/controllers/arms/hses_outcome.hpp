#pragma once

// What a request to the High Speed Ethernet Server comes to: data, or the code of a refusal.
//
//   return hses_elements(request, {mode, state});       // what the request wants of them

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/arm/motoman/hses_packet.hpp"

namespace pizarra::simulation {

struct HsesOutcome {
  std::uint16_t refusal = 0;
  std::string data = {};
};

// All of these, or the one whose number is the attribute.
HsesOutcome hses_elements(const arm::HsesRequest& request, const std::vector<std::string>& elements);

}  // namespace pizarra::simulation
