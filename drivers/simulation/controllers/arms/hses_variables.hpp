#pragma once

// Variables, registers and inputs and outputs of the High Speed Ethernet Server: one, an element of one, or several. D
// variables are the controller's own, the others are kept here.
//
//   HsesVariables variables(controller);
//   if (HsesVariables::has(request.command)) outcome = co_await variables.carry_out(request);

#include <cstddef>
#include <map>
#include <utility>

#include "drivers/simulation/controllers/arms/hses_outcome.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

class HsesVariables {
 public:
  // The controller outlives it.
  explicit HsesVariables(MotomanController& controller) : controller_(controller) {}
  // Whether the command is about one variable, or about several.
  static bool has(std::uint16_t command);
  Task<HsesOutcome> carry_out(arm::HsesRequest request);

 private:
  struct Kind {
    std::uint16_t command;
    std::uint16_t first;
    std::uint16_t last;
    std::size_t octets;
    std::size_t element;  // octets of each of its elements
  };
  static const Kind kinds[];
  // Of a command about one variable; null of others.
  static const Kind* kind_of(std::uint16_t command);
  static bool may_be_set(const Kind& kind, std::uint16_t number);
  Task<HsesOutcome> one(arm::HsesRequest request, Kind kind);
  Task<HsesOutcome> several(arm::HsesRequest request, Kind kind);
  Task<std::string> value(Kind kind, std::uint16_t number);
  Task<std::uint16_t> set_value(Kind kind, std::uint16_t number, std::string octets);

  MotomanController& controller_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::string> values_;  // by command and number
};

}  // namespace pizarra::simulation
