#pragma once

// Holds what the clients were told against what the board's journal says in the end.

#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "lisp/result.hpp"
#include "tests/bench/crash/clients.hpp"

namespace pizarra::bench {

struct Verdict {
  std::size_t acknowledged = 0;
  std::size_t lost = 0;                // acknowledged, and neither there nor made into an effect
  std::size_t duplicated_effects = 0;  // made twice, or made and still there
  std::size_t gaps = 0;                // in what a watcher was told, without a resynchronisation
};

class Judge {
 public:
  void hear(const Report& report);
  // Failures of read_journal().
  Result<Verdict> judge(const std::string& journal) const;
  // Items that nobody has made an effect of yet, as far as anybody said so.
  std::size_t unmade() const;

 private:
  using Item = std::pair<std::int64_t, std::int64_t>;
  std::set<Item> told_;
  std::set<Item> made_;
  std::size_t gaps_ = 0;
};

}  // namespace pizarra::bench
