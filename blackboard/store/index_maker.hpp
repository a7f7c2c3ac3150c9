#pragma once

// Makes the indexes of a board a part at a time, so that others are served between the parts.
//
//   maker.on_wanted = [&] { schedule(); };                   // without, they are made at once
//   while (!maker.is_idle()) {                               // others are served meanwhile
//     const IndexMaker::Part part = maker.make_some();       // between searches alone
//     ...                                                    // part.client is who it was made for
//   }
//
// Of each client one is made at a time, of each in its turn, and 16 in all: who needs another one meanwhile awaits one
// of these first.

#include <deque>
#include <functional>
#include <string>

#include "blackboard/store/indexing.hpp"

namespace pizarra::store {

class IndexMaker {
 public:
  static constexpr std::size_t most = 16;

  std::function<void()> on_wanted;

  // For what is nobody's in particular.
  Indexing::May may() const { return on_wanted ? Indexing::May::make_in_parts : Indexing::May::make_at_once; }
  // What to await, and then to look again.
  IndexTicket want(TableIndexes& table, const FactIndex::Kind& kind, const std::string& client);
  bool is_idle() const { return makings_.empty(); }
  bool is_under_way(IndexTicket ticket) const;
  struct Part {
    std::string client;
    std::size_t examined = 0;  // as many facts could have been looked at meanwhile
    IndexTicket made = 0;      // if this was its last part
  };
  // It must not be idle.
  Part make_some();

 private:
  struct Making {
    IndexTicket ticket;
    TableIndexes* table;
    FactIndex::Kind kind;
    std::string client;
  };

  std::deque<Making> makings_;
  IndexTicket next_ticket_ = 1;
};

}  // namespace pizarra::store
