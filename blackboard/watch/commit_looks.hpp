#pragma once

// How many facts watches look at to follow one commit: limits::examined for all of them together, however many there
// are, and beyond that limits::examined_a_turn for each reader, so that who watches little follows whatever others
// watch.
//
//   CommitLooks looks;                                      // of one commit
//   std::size_t examined = looks.before(reader);            // a search that goes on from there ends in time
//   ...
//   looks.add(reader, examined - looks.before(reader));

#include <algorithm>
#include <map>

#include "blackboard/limits.hpp"
#include "blackboard/watch/backlog.hpp"

namespace pizarra {

class CommitLooks {
 public:
  // One for all that share a backlog.
  using Reader = const Backlog*;

  std::size_t before(Reader reader) const {
    const auto own = own_.find(reader);
    const std::size_t of_own = left(limits::examined_a_turn, own == own_.end() ? 0 : own->second);
    return limits::examined - std::max(of_own, left(limits::examined, all_));
  }
  void add(Reader reader, std::size_t examined) {
    all_ += examined;
    own_[reader] += examined;
  }

 private:
  static std::size_t left(std::size_t most, std::size_t examined) { return most - std::min(most, examined); }

  std::size_t all_ = 0;
  std::map<Reader, std::size_t> own_;
};

}  // namespace pizarra
