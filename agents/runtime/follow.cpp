#include "agents/runtime/follow.hpp"

#include "agents/runtime/declared.hpp"

namespace pizarra::runtime {

Task<void> follow(AgentContext& context, Datum pattern, std::function<Task<void>(Change)> take) {
  const Query query = query_for(std::move(pattern));
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await watch_when_declared(context.board, query);
    while (watch) {
      Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      co_await take(std::move(*change));
    }
    co_await sleep(context.executor, retry_pause);
  }
}

}  // namespace pizarra::runtime
