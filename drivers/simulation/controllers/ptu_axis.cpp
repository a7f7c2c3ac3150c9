#include "drivers/simulation/controllers/ptu_axis.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::simulation {

namespace {

constexpr Duration step_time = 1ms;
constexpr double step_s = 0.001;

}  // namespace

void PtuAxis::advance(Duration time) {
  rest_ += time;
  while (rest_ >= step_time) {
    rest_ -= step_time;
    if (moving()) {
      step(step_s);
    } else {
      rest_ %= step_time;
    }
  }
}

void PtuAxis::step(double seconds) {
  const double distance = target_ - at_;
  const double way = distance < 0 ? -1 : 1;
  const double base = speeds_.base;
  const double gain = speeds_.acceleration * seconds;
  // The steps in which it can still slow down to the base speed before the target.
  const double slowing = std::sqrt(base * base + 2 * speeds_.acceleration * std::abs(distance));
  const double most = std::min<double>(speeds_.speed, slowing);
  double along = velocity_ * way;
  along = along < 0 ? along + gain : std::min(std::max(along + gain, base), std::max(most, along - gain));
  velocity_ = along * way;
  if (along * seconds >= std::abs(distance)) {
    at_ = target_;
    velocity_ = 0;
  } else {
    at_ += velocity_ * seconds;
  }
}

void PtuAxis::go_to(int target) {
  const double wanted = offset_ + target;
  target_ = std::clamp<double>(wanted, model_.low, model_.high);
  hits_stop_ = target_ != wanted;
}

void PtuAxis::go_to_stop(bool high) {
  target_ = high ? model_.high : model_.low;
  hits_stop_ = true;
}

void PtuAxis::halt() {
  hits_stop_ = false;
  const double excess = std::max(0.0, velocity_ * velocity_ - static_cast<double>(speeds_.base) * speeds_.base);
  const double way = velocity_ < 0 ? -1 : 1;
  target_ = std::round(at_ - offset_ + way * excess / (2 * speeds_.acceleration)) + offset_;
  if (velocity_ == 0) at_ = target_;
}

void PtuAxis::lose_power() {
  hits_stop_ = false;
  at_ = std::round(at_);
  target_ = at_;
  offset_ = at_;
  velocity_ = 0;
}

int PtuAxis::position() const { return static_cast<int>(std::lround(at_ - offset_)); }

int PtuAxis::moving_speed() const { return static_cast<int>(std::lround(velocity_)); }

}  // namespace pizarra::simulation
