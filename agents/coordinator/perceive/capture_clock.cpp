#include "agents/coordinator/perceive/capture_clock.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

// So few that clocks which drift hardly part meanwhile, and so many that one of them was fast.
constexpr std::size_t looks_lately = 30;
constexpr std::size_t fewest_looks = 5;

}  // namespace

std::optional<Time> CaptureClock::on_board(Time captured, Time told) {
  differences_.push_back(told - captured);
  if (differences_.size() > looks_lately) differences_.pop_front();
  if (differences_.size() < fewest_looks) return std::nullopt;
  return captured + std::ranges::min(differences_);
}

}  // namespace pizarra::coordinator
