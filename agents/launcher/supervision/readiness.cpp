#include "agents/launcher/supervision/readiness.hpp"

#include <fmt/format.h>

namespace pizarra {

namespace {

constexpr Duration agents_timeout = 20s;
constexpr Duration teaching_timeout = 120s;
constexpr Duration declared_pause = 100ms;

}  // namespace

Task<Result<Answer>> await_when_declared(Board& board, Executor& executor, Query query, Time deadline) {
  while (true) {
    Result<Answer> answer = co_await await_answer(board, query, deadline, executor);
    if (answer || answer.error().symbol != "undeclared-relation") co_return answer;
    if (executor.now() >= deadline) co_return answer;
    co_await sleep(executor, declared_pause);
  }
}

Task<Result<void>> await_agents(LocalCell& cell, Board& board) {
  const Time deadline = cell.executor().now() + agents_timeout;
  const std::vector<std::string> kinds = agent_kinds(cell.description());
  for (const std::string& kind : kinds) {
    Query query = query_for(list("agent"_sym, Datum::symbol(kind), "?"_sym, "?"_sym));
    const Result<Answer> there = co_await await_when_declared(board, cell.executor(), std::move(query), deadline);
    if (there) continue;
    const std::optional<Failure> why = cell.ended(kind);
    const std::string reason = why.has_value() ? ": " + describe(*why) : std::string();
    co_return fail("no-agents", fmt::format("the {} agent does not come up{}", kind, reason));
  }
  co_return {};
}

Task<Result<void>> await_teaching(Board& board, Executor& executor) {
  const Time deadline = executor.now() + teaching_timeout;
  const Datum form =
      list("and"_sym, list("person"_sym, "?state"_sym, "?detail"_sym), list("/="_sym, "?state"_sym, "teaching"_sym));
  Query query = query_from_datum(form).value();
  const Result<Answer> end = co_await await_when_declared(board, executor, std::move(query), deadline);
  if (!end) co_return fail("not-taught", "the objects were not learned in time");
  if (end->bindings.find("?state")->is_symbol("done")) co_return {};
  const Failure why = failure_from_datum(*end->bindings.find("?detail"));
  co_return fail("not-taught", why.sentence, why.subject);
}

}  // namespace pizarra
