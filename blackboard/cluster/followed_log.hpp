#pragma once

// A cell's log in a cluster, followed entry by entry into a store in memory. A standby has one, and whoever reads the
// log begins with one.
//
//   FollowedLog followed(key_values, LogKeys("blocks"));
//   Result<std::size_t> came = followed.follow();  // some entries; 0: that is all there is
//   followed.store(); followed.number();           // the newest entry that it has
//   followed.alive();                              // what the leader said last
//
// Entries are numbered without a gap. Where the next one is gone, because others came meanwhile and a snapshot took
// their place, it begins anew from that. A gap that no snapshot fills is damage. Failures: unavailable, bad-journal,
// other-format.

#include <memory>

#include "blackboard/cluster/log_keys.hpp"
#include "blackboard/cluster/log_space.hpp"
#include "blackboard/cluster/snapshot.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::cluster {

class FollowedLog {
 public:
  // Entries may be large, or the line slow: half as many are asked for after an answer that did not come in time, and
  // one more after each that did. The leader's word may be among them.
  static constexpr std::size_t most_at_once = 128;
  static constexpr std::size_t least_at_once = 2;

  // In a store of its own; or up to a moment, into an empty one of the caller's.
  FollowedLog(KeyValues& key_values, LogKeys keys) : key_values_(key_values), keys_(std::move(keys)) {}
  FollowedLog(KeyValues& key_values, LogKeys keys, store::Store& into, Moment until)
      : key_values_(key_values), keys_(std::move(keys)), into_(&into), until_(until) {}

  Result<std::size_t> follow();
  // Whether there may be more, before what the leader said last.
  bool is_behind() const { return is_behind_; }
  // Until it has the entry with that number. Asks for fewer entries where an answer did not come in time.
  Result<void> follow_to(std::uint64_t number);

  const std::optional<Alive>& alive() const { return alive_; }
  std::uint64_t number() const { return number_; }
  store::Store& store() { return *store_; }
  std::unique_ptr<store::Store> take_store() { return std::move(own_); }
  // Of the last revision that it has.
  const journal::LineStart& end() const { return end_; }
  const std::string& later() const { return later_; }
  std::vector<journal::RememberedReply> replies() const;
  const LogWeight& weight() const { return weight_; }

  // As a snapshot of it: lines of text.
  std::string text() const;

 private:
  Result<std::size_t> follow_some();
  Result<std::size_t> take(const std::vector<KeyValue>& values);
  Result<void> check_gap();
  Result<void> heard(const std::string& alive);
  Result<std::vector<KeyValue>> next_entries();
  Result<std::vector<KeyValue>> some_of(const KeyValues::Range& range);
  Result<void> begin();
  Result<void> restore_snapshot();
  Result<void> part_is_missing(const std::string& snapshot);
  Result<void> restore(const std::string& text);
  Result<void> restore_line(const Datum& line);
  Result<void> apply(const Entry& entry);
  void remember(Time when, std::vector<journal::RememberedReply> replies);

  KeyValues& key_values_;
  const LogKeys keys_;
  store::Store* into_ = nullptr;
  const Moment until_ = {};
  std::unique_ptr<store::Store> own_;
  store::Store* store_ = nullptr;          // null before it begins
  std::optional<std::string> begun_from_;  // the snapshot, as its pointer says
  std::uint64_t number_ = 0;
  std::size_t at_once_ = most_at_once;
  bool is_behind_ = false;
  int begun_ = 0;  // how often it had to begin anew
  journal::LineStart end_;
  std::string later_;
  std::optional<Alive> alive_;
  DatedReplies replies_;
  LogWeight weight_;
};

}  // namespace pizarra::cluster
