#pragma once

// Where a cell's log lies among the keys of a cluster, and what is written there, so that people can read it. The cell
// and who leads:
//
//   pizarra/CELL/cell              NAME, or NAME KEY               of the cell whose log it is
//   pizarra/CELL/format            NUMBER                          of how all this is written (log_format.hpp)
//   pizarra/CELL/epoch             (epoch NUMBER BOARD NONCE)      who leads
//
// The log, of which a board that leads renews `alive` every 100 ms:
//
//   pizarra/CELL/head              NUMBER                          of the newest entry
//   pizarra/CELL/log/0000000000042 (entry NUMBER EPOCH SUM) and its lines, then its replies
//   pizarra/CELL/log/alive         (alive EPOCH COUNT TIME REVISION FACT LEAVING)
//
// The snapshots:
//
//   pizarra/CELL/snapshot          (snapshot NUMBER NONCE PARTS)   which one counts
//   pizarra/CELL/snapshots/NUMBER-NONCE/0000   its parts
//
// The revision and the fact of `alive` are beyond any that the board uses before it says the next one.

#include <cstdint>
#include <string>

#include "blackboard/cluster/key_values.hpp"
#include "blackboard/journal/log.hpp"

namespace pizarra::cluster {

class LogKeys {
 public:
  explicit LogKeys(const std::string& cell) : base_("pizarra/" + cell + "/") {}
  std::string cell() const { return base_ + "cell"; }
  std::string format() const { return base_ + "format"; }
  std::string epoch() const { return base_ + "epoch"; }
  std::string head() const { return base_ + "head"; }
  std::string alive() const { return base_ + "log/alive"; }
  std::string entry(std::uint64_t number) const;
  std::string snapshot() const { return base_ + "snapshot"; }
  std::string snapshot_part(const std::string& name, std::size_t part) const;
  KeyValues::Range parts_of(const std::string& name) const;
  // All snapshots but that one.
  std::vector<KeyValues::Range> snapshots_but(const std::string& name) const;
  // Not `to` itself.
  KeyValues::Range entries(std::uint64_t from, std::uint64_t to) const { return {entry(from), entry(to)}; }
  // From that one on; what the leader says comes behind them.
  KeyValues::Range entries_and_alive(std::uint64_t from) const { return {entry(from), base_ + "log0"}; }

 private:
  std::string base_;
};

struct EpochValue {
  std::uint64_t number = 0;
  std::string board;
  std::uint64_t nonce = 0;
  bool operator==(const EpochValue&) const = default;
};
std::string text_of(const EpochValue& epoch);
// Failure bad-journal, here and below.
Result<EpochValue> epoch_from(const std::string& text);

struct Alive {
  std::uint64_t epoch = 0;
  std::uint64_t count = 0;
  Time when{};
  Revision revision = 0;
  FactId fact = 0;
  bool leaves = false;  // it answers nobody any more
  bool operator==(const Alive&) const = default;
};
std::string text_of(const Alive& alive);
Result<Alive> alive_from(const std::string& text);

// The number of the newest entry; nothing where the store has no log of the cell. Failures unavailable, bad-journal.
Result<std::optional<std::uint64_t>> head_of(KeyValues& key_values, const LogKeys& keys);

struct Entry {
  std::uint64_t number = 0;
  std::uint64_t epoch = 0;
  journal::JournalGroup group;
};
std::string text_of(std::uint64_t number, std::uint64_t epoch, const journal::JournalGroup& group);
Result<Entry> entry_from(const std::string& text);

}  // namespace pizarra::cluster
