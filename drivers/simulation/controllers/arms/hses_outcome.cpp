#include "drivers/simulation/controllers/arms/hses_outcome.hpp"

namespace pizarra::simulation {

HsesOutcome hses_elements(const arm::HsesRequest& request, const std::vector<std::string>& elements) {
  if (request.service == arm::hses::get_all) {
    if (request.attribute != 0) return {.refusal = arm::hses::wrong_attribute};
    HsesOutcome all;
    for (const std::string& element : elements) all.data += element;
    return all;
  }
  if (request.service != arm::hses::get_one) return {.refusal = arm::hses::undefined_command};
  if (request.attribute < 1 || request.attribute > elements.size()) return {.refusal = arm::hses::wrong_attribute};
  return {.data = elements[request.attribute - 1u]};
}

}  // namespace pizarra::simulation
