#pragma once

// Whether a board has room for what a transaction adds to it: a bound on the facts, and one on their bytes.
//
//   const Result<void> room = check_room(transaction, weigh(transaction), teller, tables, {.facts = n, .bytes = b});

#include "blackboard/board.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/store/fact_table.hpp"

namespace pizarra::store {

// The facts that stand on the board and stay.
struct Load {
  std::size_t facts = 0;
  std::size_t bytes = 0;
};

Weight weigh(const Transaction& transaction);
// In whatever order it goes about it, what adds nothing always has room. Its relations are declared. Failure too-large.
Result<void> check_room(const Transaction& transaction, const Weight& weight, const std::string& teller,
                        const Tables& tables, const Load& taken);

}  // namespace pizarra::store
