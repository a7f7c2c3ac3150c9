#pragma once

// The log of a board that leads, in a cluster: the wall beside the SQLite file (journal/log.hpp). A group is one entry
// under the next number, written where the epoch and the head are this board's; what was begun and not answered is
// looked up before it is repeated.
//
//   auto log = std::make_shared<ClusterLog>(key_values, keys, epoch.value(), copy.number(), "etcd://.../blocks");
//   JournalWriter writer(executor, log);
//
// Only lines about what is durable belong there (MemoryBoard::set_journal). Snapshots are taken beside it (LogUpkeep),
// because compaction here would keep a group waiting.

#include <memory>

#include "blackboard/cluster/followed_log.hpp"
#include "blackboard/cluster/log_keys.hpp"
#include "blackboard/journal/log.hpp"

namespace pizarra::cluster {

class ClusterLog : public journal::Log {
 public:
  // `reading` is for questions about the past, which come from another thread. `weight`: of the log up to its head.
  ClusterLog(std::shared_ptr<KeyValues> key_values, std::shared_ptr<KeyValues> reading, LogKeys keys, EpochValue epoch,
             std::uint64_t head, std::string path, const LogWeight& weight = {});

  const std::string& path() const override { return path_; }
  Result<std::vector<journal::RememberedReply>> recover(store::Store& store) override;
  Result<void> append(const journal::JournalGroup& group, bool may_spend) override;
  journal::JournalRoom room() override;
  Result<std::size_t> compact(Time) override { return 0; }
  Result<journal::PlayedBack> read(store::Store& store, const Moment& until) const override;
  std::size_t group_bytes() const override { return 256 << 10; }

  std::uint64_t head() const { return head_; }
  const std::shared_ptr<LogSpace>& space() const { return space_; }

 private:
  // Whether the entry after the head is that text; failure deposed where it is another.
  Result<bool> stands(const std::string& text);
  void is_written(const std::string& text);

  const std::shared_ptr<KeyValues> key_values_;
  const std::shared_ptr<KeyValues> reading_;
  const LogKeys keys_;
  const EpochValue epoch_;
  const std::string path_;
  const std::shared_ptr<LogSpace> space_;
  std::uint64_t head_;
  bool in_doubt_ = false;
  std::optional<Failure> deposed_;
};

// The log of a cell as of a moment, whether a board leads it or not: into an empty store. Facts that are not durable
// have revisions too, so the moment may lie behind the last entry.
Result<journal::PlayedBack> read_log(KeyValues& key_values, const LogKeys& keys, store::Store& store,
                                     const Moment& until);

}  // namespace pizarra::cluster
