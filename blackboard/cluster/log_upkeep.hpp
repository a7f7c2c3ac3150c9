#pragma once

// Keeps a cell's log within the space that its store has: snapshots when they are due, and the store forgets what they
// replaced. A store that was full, and refuses, is emptied of what nobody needs and takes new things again.
//
//   LogUpkeep upkeep(key_values, keys, log->space());
//   Result<void> kept = upkeep.step(now, nonce);        // every upkeep_every, while its board leads
//
// Failures: unavailable, bad-journal.

#include <memory>

#include "blackboard/cluster/log_keys.hpp"
#include "blackboard/cluster/log_space.hpp"

namespace pizarra::cluster {

inline constexpr Duration upkeep_every = 100ms;

class LogUpkeep {
 public:
  static constexpr Duration looks_for_space_every = 1s;
  // After a snapshot that made no room, for the second time and later.
  static constexpr Duration first_pause = 1s;
  static constexpr Duration longest_pause = 32s;

  LogUpkeep(std::shared_ptr<KeyValues> key_values, LogKeys keys, std::shared_ptr<LogSpace> space)
      : key_values_(std::move(key_values)), keys_(std::move(keys)), space_(std::move(space)) {}

  // A nonce is another one for every snapshot.
  Result<void> step(Time now, std::uint64_t nonce);

 private:
  Result<void> look_for_space(Time now);
  Result<void> forget();
  void pause_where_full(Time now);

  const std::shared_ptr<KeyValues> key_values_;
  const LogKeys keys_;
  const std::shared_ptr<LogSpace> space_;
  Time looks_at_{};
  bool owes_forgetting_ = false;
  Time snapshots_at_{};
  Duration pause_{};
  bool was_full_ = false;
};

// Where the store refuses: has it forget what keys were, closes its holes where that is not enough, and ends the
// refusing. Failure unavailable, which says where there is no space even so.
Result<void> make_space(KeyValues& key_values);

}  // namespace pizarra::cluster
