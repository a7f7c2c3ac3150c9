#include "drivers/simulation/controllers/arms/ur_messages.hpp"

#include <chrono>
#include <utility>

namespace pizarra::simulation {

std::uint64_t UrMessages::now_us() const {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(executor_.now().time_since_epoch()).count());
}

void UrMessages::say(std::string message) {
  if (said_.size() < most) said_.push_back(std::move(message));
}

std::string UrMessages::take() {
  std::string all;
  for (const std::string& message : std::exchange(said_, {})) all += message;
  return all;
}

}  // namespace pizarra::simulation
