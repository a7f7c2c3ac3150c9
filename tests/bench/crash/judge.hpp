#pragma once

// Holds what the clients were told against what the journal, or the log, says in the end.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "blackboard/store/store.hpp"
#include "tests/bench/crash/clients.hpp"

namespace pizarra::bench {

struct Verdict {
  std::size_t acknowledged = 0;
  std::size_t lost = 0;                // acknowledged, and neither there nor made into an effect
  std::size_t duplicated_effects = 0;  // made twice, or made and still there; taken twice, or taken and still there
  std::size_t gaps = 0;                // in what a watcher was told, without a resynchronisation
  std::size_t not_linearizable = 0;    // registers
  std::size_t operations = 0;          // on registers
  std::string unexplained = {};        // the registers that are not linearizable, with what was done to each
};

class Judge {
 public:
  void hear(const Report& report);
  Verdict judge(const store::Store& end) const;
  // Whether anything was acknowledged, and answered of a register.
  bool has_begun() const { return !told_.empty() && !registers_.empty(); }
  // Items that nobody has made an effect of yet, as far as anybody said so.
  std::size_t unmade() const;

 private:
  using Item = std::pair<std::int64_t, std::int64_t>;
  void judge_registers(const store::Store& end, Verdict& verdict) const;

  std::set<Item> told_;
  std::set<Item> made_;
  std::map<Item, std::size_t> got_;
  std::map<std::int64_t, std::map<std::int64_t, Operation>> registers_;
  std::size_t gaps_ = 0;
};

}  // namespace pizarra::bench
