#pragma once

// A snapshot of a cell's log: all that stands for durable, and what is remembered, as text in parts.
//
//   Result<SnapshotValue> put = put_snapshot(key_values, keys, 42, "42-7", snapshot_text(store, end, replies));
//   key_values.transact({.compares = ..., .puts = {{keys.snapshot(), text_of(*put)}}}, patience);   // from now it
//   counts
//
// Parts that no snapshot names count for nothing. FollowedLog reads them.

#include <deque>

#include "blackboard/cluster/log_keys.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::cluster {

// (snapshot NUMBER NAME PARTS SUM)
struct SnapshotValue {
  std::uint64_t number = 0;  // of the newest entry in it
  std::string name;
  std::uint64_t parts = 0;
  std::int64_t sum = 0;
};
// Failure bad-journal.
Result<SnapshotValue> snapshot_from(const std::string& text);
std::string text_of(const SnapshotValue& snapshot);

// When each was given, oldest first.
using DatedReplies = std::deque<std::pair<Time, journal::RememberedReply>>;

std::string snapshot_text(const store::Store& store, const journal::LineStart& end, const DatedReplies& replies);
// Writes its parts. Failure unavailable.
Result<SnapshotValue> put_snapshot(KeyValues& key_values, const LogKeys& keys, std::uint64_t number,
                                   const std::string& name, const std::string& text);

}  // namespace pizarra::cluster
