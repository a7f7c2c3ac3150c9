#pragma once

// The device's end of Universal Robots' Real-Time Data Exchange: what one client has agreed on.
//
//   UrExchange exchange;
//   exchange.answer(message)               // to all that is not data; empty: nothing is said
//   exchange.take(payload)                 // data of one of the client's recipes: names and numbers
//   exchange.tell(state)                   // data, as the client wants to be told
//
// Protocol version 2. One recipe of outputs, the last agreed on; up to 30 of inputs.

#include <vector>

#include "blackboard/time/clock.hpp"
#include "drivers/simulation/controllers/arms/ur_fields.hpp"

namespace pizarra::simulation {

class UrExchange {
 public:
  std::string answer(std::string_view message);
  // Empty where it is no data of a recipe that there is.
  std::vector<std::pair<std::string, double>> take(std::string_view payload) const;
  std::string tell(const UrState& state) const;
  // How often; none where it has not started that, or has paused it.
  std::optional<Duration> told_every() const { return telling_ ? std::optional(period_) : std::nullopt; }

 private:
  struct Field {
    std::string name;
    UrType type;
  };
  using Recipe = std::vector<Field>;
  static constexpr std::uint8_t output_recipe = 1;
  std::string agree_on_outputs(std::string_view payload);
  std::string agree_on_inputs(std::string_view names);

  Recipe outputs_;
  std::vector<Recipe> inputs_;
  bool telling_ = false;
  Duration period_ = 8ms;
};

}  // namespace pizarra::simulation
