#pragma once

// How much of its store a cell's log takes up, and so when a snapshot is due and what the board may still add. A
// snapshot is written beside the former one, and what it replaces lasts until the store forgets it: a log has no more
// than a quarter of the space, so that this always fits.
//
//   LogSpace space(copy.weight());
//   space.set_most(etcd's quota);
//   space.wrote(entry.size());                          // as entries are written
//   if (space.is_snapshot_due()) ...                    // log_upkeep.hpp
//   space.room("etcd://A,B,C/CELL")                     // what JournalWriter may let wait
//
// Its members may be called from any thread.

#include <cstdint>
#include <mutex>
#include <string>

#include "blackboard/journal/journal_room.hpp"

namespace pizarra::cluster {

struct LogWeight {
  std::uint64_t snapshot_bytes = 0;
  std::uint64_t entries = 0;  // since the snapshot
  std::uint64_t bytes = 0;    // of these

  std::uint64_t all() const { return snapshot_bytes + bytes; }
};

class LogSpace {
 public:
  static constexpr std::uint64_t entries_a_snapshot = 10'000;
  static constexpr std::uint64_t bytes_a_snapshot = 64 << 20;
  // Below what etcd takes in a request, 1.5 MB.
  static constexpr std::size_t largest_entry = 1400 << 10;
  // Of waiting groups, where there is more space.
  static constexpr std::size_t may_wait_bytes = 16 << 20;

  explicit LogSpace(const LogWeight& weight = {}) : weight_(weight) {}

  void set_most(std::uint64_t bytes);
  void wrote(std::uint64_t bytes);
  LogWeight weight() const;
  // Of all that the log had when it weighed `before`.
  void snapshot_taken(const LogWeight& before, std::uint64_t bytes);
  bool is_snapshot_due() const;
  // Whether nothing may be added.
  bool is_full() const;
  journal::JournalRoom room(const std::string& path) const;

 private:
  mutable std::mutex mutex_;
  std::uint64_t most_ = std::uint64_t{2} << 30;  // etcd's own quota
  LogWeight weight_;
};

}  // namespace pizarra::cluster
