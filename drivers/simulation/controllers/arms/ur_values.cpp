#include "drivers/simulation/controllers/arms/ur_values.hpp"

namespace pizarra::simulation {

void UrValues::set_output(int number, bool on) {
  const std::uint32_t bit = 1u << number;
  outputs_ = on ? outputs_ | bit : outputs_ & ~bit;
}

void UrValues::set_outputs(std::string_view bank) {
  const std::string name(bank);
  const auto bits = [this](const std::string& field) {
    const auto found = numbers_.find(field);
    return found == numbers_.end() ? 0u : static_cast<std::uint32_t>(found->second);
  };
  const int first = bank == "configurable" ? 8 : bank == "tool" ? 16 : 0;
  const std::uint32_t mask = bits(name + "_digital_output_mask") << first;
  outputs_ = (outputs_ & ~mask) | (bits(name + "_digital_output") << first & mask);
}

}  // namespace pizarra::simulation
