#pragma once

// A fact on the board with its provenance: who told it, when, at which revision, and because of which other facts.
//
// The board makes it when it is told, and it does not change: what is told with the same key later is another fact.
//
//   const Result<std::vector<Fact>> found = co_await board.facts(list("on"_sym, "?"_sym, "?"_sym));
//   found->front().datum[1].text();              // "circle", of (on circle triangle)
//   co_await board.tell(conclusion, {found->front().id});

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/datum.hpp"

namespace pizarra {

using Revision = std::uint64_t;  // 1 is the first committed transaction
using FactId = std::uint64_t;    // a counter, never used twice on one board
using LeaseId = std::uint64_t;   // 0: none

// A moment of a board's past, by revision or by time: what came later is left out.
struct Moment {
  Revision revision = std::numeric_limits<Revision>::max();
  Time time = Time::max();
  bool operator==(const Moment&) const = default;
};

struct Fact {
  Datum datum;
  FactId id = 0;
  std::string teller;
  Time when{};
  Revision revision = 0;
  std::vector<FactId> because;
  bool operator==(const Fact&) const = default;
};

}  // namespace pizarra
