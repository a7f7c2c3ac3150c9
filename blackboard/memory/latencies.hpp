#pragma once

// How long something took in the last ten to twenty seconds: how often it happened, the median, and the 90th and 99th
// percentile. Each is exact to a fifth.
//
//   Latencies latencies;
//   latencies.add(120us, now);
//   latencies.summary(now).p99;

#include <array>
#include <cstddef>
#include <cstdint>

#include "blackboard/time/clock.hpp"

namespace pizarra::memory {

class Latencies {
 public:
  struct Summary {
    std::uint64_t count = 0;
    Duration p50{};
    Duration p90{};
    Duration p99{};
  };

  void add(Duration took, Time now);
  Summary summary(Time now);

 private:
  static constexpr std::size_t steps = 4;  // from one power of two to the next
  static constexpr std::size_t buckets = 27 * steps;
  using Counts = std::array<std::uint32_t, buckets>;

  static std::size_t bucket_of(Duration took);
  static Duration longest_in(std::size_t bucket);
  void pass_to(Time now);
  Duration within(double share, std::uint64_t count) const;

  Time begun_{};
  Counts now_{};
  Counts before_{};
};

}  // namespace pizarra::memory
