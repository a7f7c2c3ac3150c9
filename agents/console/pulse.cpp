#include "agents/console/pulse.hpp"

#include <algorithm>

#include "agents/runtime/hold_deadlines.hpp"

namespace pizarra::console {

namespace {

// How much of what is known a new measurement changes.
constexpr int smoothing = 8;

}  // namespace

std::int64_t Pulse::beat(Time now) {
  sent_.push_back(now);
  if (sent_.size() > most_stamps) sent_.pop_front();
  return ++newest_;
}

std::optional<Time> Pulse::sent_at(std::int64_t stamp) const {
  const std::int64_t back = newest_ - stamp;
  if (back < 0 || back >= static_cast<std::int64_t>(sent_.size())) return std::nullopt;
  return sent_[sent_.size() - 1 - static_cast<std::size_t>(back)];
}

void Pulse::came_back(std::int64_t stamp, Time now) {
  const std::optional<Time> sent = sent_at(stamp);
  if (!sent) return;
  const Duration took = now - *sent;
  measured_.push_back(took);
  if (measured_.size() > most_stamps) measured_.pop_front();
  round_trip_ = round_trip_ ? *round_trip_ + (took - *round_trip_) / smoothing : took;
}

std::optional<Duration> Pulse::line() const {
  if (measured_.empty()) return std::nullopt;
  return *std::ranges::min_element(measured_);
}

bool Pulse::is_fresh(std::int64_t stamp, Time now, Duration deadline) const {
  const std::optional<Time> sent = sent_at(stamp);
  return sent && now - *sent < deadline;
}

Duration Pulse::deadline() const {
  if (!round_trip_) return runtime::longest_hold_deadline;
  return std::clamp<Duration>(150ms + *round_trip_ * 5 / 2, runtime::least_hold_deadline,
                              runtime::longest_hold_deadline);
}

}  // namespace pizarra::console
