#pragma once

// Sets of facts that cannot all hold after a number of steps, found by failed searches.
//
//   Nogoods nogoods;
//   nogoods.add({2, 5, 9}, 4);                       // not together after 4 steps, nor after fewer
//   nogoods.find(goals, 3);                          // a nogood within `goals` that is proved for 3 steps, or none
//
// A trie over ascending facts: a lookup follows only the wanted facts (Hoffmann & Koehler, "A new method to index and
// query sets", 1999). Facts that cannot be reached in k steps cannot be reached in fewer, so one number a nogood is
// enough.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/planner/task/bits.hpp"

namespace pizarra::planner {

class Nogoods {
 public:
  struct Entry {
    std::vector<std::size_t> facts;  // ascending
    std::size_t level = 0;           // highest number of steps it is proved for
    std::size_t node = 0;
  };

  // The empty set is a bug of the caller. Raises the level of a set that is known already.
  void add(std::vector<std::size_t> facts, std::size_t level);
  void raise(std::size_t entry, std::size_t level);
  // The index of a nogood whose facts all stand in `goals` and which is proved for `level` steps at least.
  std::optional<std::size_t> find(const Bits& goals, std::size_t level) const;
  const std::vector<Entry>& entries() const { return entries_; }
  std::size_t bytes() const { return entries_.size() * sizeof(Entry) + nodes_.size() * (sizeof(Node) + 16); }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Node {
    std::uint32_t fact = 0;
    std::uint32_t parent = none;
    std::uint32_t first_child = none;
    std::uint32_t next_sibling = none;
    std::uint32_t entry = none;   // of the nogood that ends here
    std::uint32_t max_level = 0;  // of this node's nogood and those below
  };
  std::uint32_t child_of(std::uint32_t node, std::size_t fact);
  std::optional<std::size_t> find_below(std::uint32_t node, const Bits& goals, std::size_t level) const;

  std::vector<Node> nodes_ = {Node{}};
  std::vector<Entry> entries_;
};

}  // namespace pizarra::planner
