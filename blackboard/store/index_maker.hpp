#pragma once

// Makes the indexes of a board a part at a time, so that others are served between the parts.
//
//   maker.on_wanted = [&] { schedule(); };                   // without, they are made at once
//   while (!maker.is_idle()) maker.make_some();              // between searches alone; others are served meanwhile
//
// At most 16 are made at a time, each in its turn: who needs another one meanwhile awaits one of these first.

#include <deque>
#include <functional>

#include "blackboard/store/indexing.hpp"

namespace pizarra::store {

class IndexMaker {
 public:
  static constexpr std::size_t most = 16;

  std::function<void()> on_wanted;

  // For work that no client asked for.
  Indexing::May may() const { return on_wanted ? Indexing::May::make_in_parts : Indexing::May::make_at_once; }
  // The ticket to await before looking again.
  IndexTicket want(TableIndexes& table, const FactIndex::Kind& kind);
  bool is_idle() const { return makings_.empty(); }
  // How many are made.
  std::uint64_t made() const { return made_; }
  // Whether none was made since then.
  bool is_awaited(IndexTicket ticket) const { return ticket > made_; }
  // It must not be idle. As many facts could have been looked at meanwhile.
  std::size_t make_some();

 private:
  struct Making {
    TableIndexes* table;
    FactIndex::Kind kind;
  };

  std::deque<Making> makings_;
  std::uint64_t made_ = 0;
};

}  // namespace pizarra::store
