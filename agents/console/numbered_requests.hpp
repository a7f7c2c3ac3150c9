#pragma once

// The requests of a page that are under way, by the numbers that the page gave them. Each is a task that tells the page
// its answer.
//
//   NumberedRequests requests(executor, voice);
//   requests.begin(7, answer_to(7));
//   requests.change_board(8, board, std::move(transaction));     // answered with nothing, or with its refusal
//
// Destroying it ends them. The voice outlives it.

#include <cstdint>
#include <map>

#include "agents/console/page_voice.hpp"
#include "blackboard/board.hpp"

namespace pizarra::console {

class NumberedRequests {
 public:
  static constexpr std::size_t most = 16;

  NumberedRequests(Executor& executor, PageVoice& voice) : executor_(executor), voice_(voice) {}

  // False where it is refused: the page has been told why.
  bool begin(std::int64_t number, Task<void> task);
  // `unmet`: what is said where a precondition does not hold.
  void change_board(std::int64_t number, Board& board, Transaction transaction, Failure unmet = {});

 private:
  Task<void> change(std::int64_t number, Board& board, Transaction transaction, Failure unmet);

  Executor& executor_;
  PageVoice& voice_;
  std::map<std::int64_t, Job> under_way_;
};

}  // namespace pizarra::console
