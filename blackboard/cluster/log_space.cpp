#include "blackboard/cluster/log_space.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra::cluster {

namespace {

// Shares of the store's space: for what is added, for removals too, and for the entries between two snapshots.
constexpr std::uint64_t adds_within = 4;
constexpr std::uint64_t removes_within = 3;
constexpr std::uint64_t entries_within = 16;

// None where the largest entry does not fit.
std::size_t left(std::uint64_t most, std::uint64_t taken) {
  const std::uint64_t bytes = most - std::min(most, taken);
  return bytes < LogSpace::largest_entry ? 0 : std::min<std::uint64_t>(bytes, LogSpace::may_wait_bytes);
}

}  // namespace

void LogSpace::set_most(std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  most_ = bytes;
}

void LogSpace::wrote(std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  ++weight_.entries;
  weight_.bytes += bytes;
}

LogWeight LogSpace::weight() const {
  const std::lock_guard lock(mutex_);
  return weight_;
}

void LogSpace::snapshot_taken(const LogWeight& before, std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  weight_.snapshot_bytes = bytes;
  weight_.entries -= before.entries;
  weight_.bytes -= before.bytes;
}

// A large snapshot is written seldom, where there is space for it.
bool LogSpace::is_snapshot_due() const {
  const std::lock_guard lock(mutex_);
  if (weight_.entries == 0) return false;
  const std::uint64_t worth_it = std::max(bytes_a_snapshot, weight_.snapshot_bytes);
  return weight_.entries >= entries_a_snapshot || weight_.bytes >= std::min(worth_it, most_ / entries_within) ||
         left(most_ / adds_within, weight_.all()) == 0;
}

bool LogSpace::is_full() const {
  const std::lock_guard lock(mutex_);
  return left(most_ / adds_within, weight_.all()) == 0;
}

journal::JournalRoom LogSpace::room(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  journal::JournalRoom room;
  room.for_all = left(most_ / adds_within, weight_.all());
  room.for_removals = left(most_ / removes_within, weight_.all());
  room.for_passing = room.for_all;
  if (room.for_all > 0) return room;
  room.is_scarce = true;
  constexpr double mega = 1 << 20;
  room.lacking = fmt::format(
      "the log {} takes up {:.1f} MB, of which a snapshot has {:.1f}, and may have {:.1f}, a quarter of etcd's quota: "
      "wait for the next snapshot, retract facts, or give etcd a larger --quota-backend-bytes",
      path, static_cast<double>(weight_.all()) / mega, static_cast<double>(weight_.snapshot_bytes) / mega,
      static_cast<double>(most_) / adds_within / mega);
  return room;
}

}  // namespace pizarra::cluster
