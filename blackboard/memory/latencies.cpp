#include "blackboard/memory/latencies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pizarra::memory {

namespace {

constexpr Duration span = 10s;

}  // namespace

std::size_t Latencies::bucket_of(Duration took) {
  const double us = static_cast<double>(std::max<Duration::rep>(took.count(), 1));
  const auto bucket = static_cast<std::size_t>(std::ceil(std::log2(us) * steps));
  return std::min(bucket, buckets - 1);
}

Duration Latencies::longest_in(std::size_t bucket) {
  return Duration(static_cast<Duration::rep>(std::exp2(static_cast<double>(bucket) / steps)));
}

void Latencies::pass_to(Time now) {
  if (now - begun_ < span) return;
  before_ = now - begun_ < 2 * span ? now_ : Counts{};
  now_ = {};
  begun_ = now;
}

void Latencies::add(Duration took, Time now) {
  pass_to(now);
  ++now_[bucket_of(took)];
}

Duration Latencies::within(double share, std::uint64_t count) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count)));
  std::uint64_t passed = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    passed += std::uint64_t{now_[bucket]} + before_[bucket];
    if (passed >= wanted) return longest_in(bucket);
  }
  return longest_in(buckets - 1);
}

Latencies::Summary Latencies::summary(Time now) {
  pass_to(now);
  Summary summary;
  summary.count = std::accumulate(now_.begin(), now_.end(), summary.count);
  summary.count = std::accumulate(before_.begin(), before_.end(), summary.count);
  if (summary.count == 0) return summary;
  summary.p50 = within(0.5, summary.count);
  summary.p90 = within(0.9, summary.count);
  summary.p99 = within(0.99, summary.count);
  return summary;
}

}  // namespace pizarra::memory
