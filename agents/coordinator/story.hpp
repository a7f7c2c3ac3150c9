#pragma once

// The story as durable facts, `(event SEQ KIND SENTENCE DETAIL)`, and the answer to `why`, which is read from it and
// from the goal's own facts: the same before and after a restart of the coordinator or of the board.
//
//   co_await story.tell("plan", "plan: (PICK-UP circle)", plan);
//   story.add(transaction, "goal", sentence, goal);      // together with what it tells of, or not at all

#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::coordinator {

// How (goal N (FACT ...)) is told, and how the (goal-state N STATE DETAIL) of a goal that has ended.
std::string goal_sentence(const Datum& goal);
std::string outcome_sentence(const Datum& goal_state);

class Story {
 public:
  static constexpr std::int64_t kept = 200;

  Story(Board& board, Executor& executor) : board_(board), executor_(executor) {}

  // Goes on with the numbers of the events that stand on the board.
  Task<void> resume();
  // KIND: goal, plan, operation, servo, difference, missing, agent or result.
  void add(Transaction& transaction, std::string_view kind, std::string_view sentence, const Datum& detail,
           std::vector<FactId> because = {});
  Task<Result<Revision>> tell(std::string_view kind, std::string_view sentence, const Datum& detail,
                              std::vector<FactId> because = {});
  // The newest chain: what was wanted, what differed and what was made of it, what is done now or how it ended.
  Task<std::vector<std::string>> why() const;

 private:
  Board& board_;
  Executor& executor_;
  std::int64_t next_ = 1;
  std::int64_t oldest_ = 1;  // of those that may stand on the board
};

}  // namespace pizarra::coordinator
