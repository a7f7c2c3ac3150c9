#pragma once

// How old a page's message is. Numbered stamps go to the page, which adds the newest that it has to whatever may move
// an arm. They also measure the round trip, which sets how long a silence may last.
//
//   Pulse pulse;
//   const std::int64_t stamp = pulse.beat(now);            // goes to the page ...
//   pulse.came_back(stamp, later);                         // ... which answers it at once
//   if (!pulse.is_fresh(said, now, pulse.deadline())) ...  // it comes too late to move anything

#include <cstdint>
#include <deque>
#include <optional>

#include "blackboard/time/clock.hpp"

namespace pizarra::console {

inline double milliseconds(Duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

class Pulse {
 public:
  static constexpr Duration quick = 50ms;  // while an arm is in the page's hands
  static constexpr Duration slow = 1s;

  std::int64_t beat(Time now);
  void came_back(std::int64_t stamp, Time now);
  // Whether that stamp was sent less than `deadline` ago.
  bool is_fresh(std::int64_t stamp, Time now, Duration deadline) const;
  // There and back, smoothed; nothing before the first has come back.
  std::optional<Duration> round_trip() const { return round_trip_; }
  // The shortest of late: what the line itself takes, without what waits on it.
  std::optional<Duration> line() const;
  // 150 ms and two and a half round trips, within the bounds that holds have (agents/runtime/hold_deadlines.hpp).
  Duration deadline() const;

 private:
  static constexpr std::size_t most_stamps = 64;

  std::optional<Time> sent_at(std::int64_t stamp) const;

  std::int64_t newest_ = 0;
  std::deque<Time> sent_;  // the newest last
  std::optional<Duration> round_trip_;
  std::deque<Duration> measured_;  // the newest last
};

}  // namespace pizarra::console
