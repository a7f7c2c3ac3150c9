#include "programs/plan/plan_clock.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <utility>

namespace pizarra::programs {

namespace {

constexpr double between_looks_s = 0.005;
constexpr double between_shows_s = 1;

}  // namespace

PlanClock::PlanClock(double limit_s) : limit_s_(limit_s), on_terminal_(isatty(STDERR_FILENO) != 0) {}

PlanClock::~PlanClock() { hide(); }

void PlanClock::hide() {
  if (std::exchange(shown_, false)) fmt::print(stderr, "\r\x1b[K");
}

double PlanClock::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

bool PlanClock::over() {
  if (interrupted_ || time_up_) return true;
  const double now_s = seconds();
  time_up_ = now_s >= limit_s_;
  if (now_s < next_look_s_) return time_up_;
  next_look_s_ = now_s + between_looks_s;
  interrupted_ = signals_.received();
  if (on_terminal_ && now_s >= next_show_s_) show(now_s);
  return interrupted_ || time_up_;
}

void PlanClock::show(double now_s) {
  next_show_s_ = now_s + between_shows_s;
  shown_ = true;
  fmt::print(stderr, "\rplanning, {:.0f} s ...", now_s);
  std::fflush(stderr);
}

}  // namespace pizarra::programs
