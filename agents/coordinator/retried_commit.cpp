#include "agents/coordinator/retried_commit.hpp"

#include "blackboard/away.hpp"

namespace pizarra::coordinator {

Task<Result<Revision>> commit(Board& board, Executor& executor, Transaction transaction) {
  while (true) {
    const Result<Revision> told = if_it_stands(co_await board.transact(transaction));
    if (told || !is_away(told.error())) co_return told;
    co_await sleep(executor, retry_pause);
  }
}

Task<std::vector<Fact>> facts_now(Board& board, Executor& executor, Datum pattern) {
  while (true) {
    Result<std::vector<Fact>> facts = co_await board.facts(pattern);
    if (facts) co_return std::move(*facts);
    if (!is_away(facts.error())) co_return std::vector<Fact>();
    co_await sleep(executor, retry_pause);
  }
}

}  // namespace pizarra::coordinator
