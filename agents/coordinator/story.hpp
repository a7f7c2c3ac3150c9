#pragma once

// The story as facts, `(event SEQ KIND SENTENCE DETAIL)`, and the answer to `why`, which is read from it: the same
// before and after a restart.

#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra {

class Story {
 public:
  static constexpr std::int64_t kept = 200;

  Story(Board& board, Executor& executor) : board_(board), executor_(executor) {}

  // Goes on with the numbers of the events that stand on the board.
  Task<void> resume();
  // KIND: goal, seen, plan, operation, servo, difference, agent or result.
  Task<Result<Revision>> tell(std::string_view kind, std::string_view sentence, const Datum& detail,
                              std::vector<FactId> because = {});
  // The newest chain: what was wanted, what differed and what was made of it, what is done now.
  Task<std::vector<std::string>> why() const;

 private:
  Board& board_;
  Executor& executor_;
  std::int64_t next_ = 1;
};

}  // namespace pizarra
