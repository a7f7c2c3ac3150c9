#pragma once

// How many facts watches look at to follow one commit: limits::examined for all of them together, and beyond that
// limits::examined_a_turn for each reader. So a reader that watches little can follow, whatever others watch. Other
// work counts as the facts that could have been looked at meanwhile, whatever comes of it: a watch that is asked to
// follow, a fact that is tried, a search that begins, an answer that comes or goes.
//
//   CommitLooks looks;                                      // of one commit
//   std::size_t examined = looks.before(reader);            // a search that goes on from there ends in time
//   ...
//   looks.add(reader, examined - looks.before(reader));

#include <algorithm>
#include <map>

#include "blackboard/limits.hpp"
#include "blackboard/watch/backlog.hpp"

namespace pizarra::watch {

class CommitLooks {
 public:
  // One for all that share a backlog.
  using Reader = const Backlog*;
  static constexpr std::size_t looks_a_watch = 8;
  static constexpr std::size_t looks_a_comparison = 2;
  static constexpr std::size_t looks_a_search = 4;
  static constexpr std::size_t looks_an_answer = 8;
  // To weigh, keep and write what comes of it.
  static constexpr std::size_t bytes_a_look = 64;
  // Patterns that the facts of a commit lead to, one by one: each takes a quarter of a look or less.
  static constexpr std::size_t most_led_to = 2 * limits::examined;

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

}  // namespace pizarra::watch
