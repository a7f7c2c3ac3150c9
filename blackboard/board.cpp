#include "blackboard/board.hpp"

#include "blackboard/time/latch.hpp"

namespace pizarra {

namespace {

Task<void> fetch_next(Watch& watch, std::optional<Result<Change>>& change, Event& fetched) {
  Result<Change> next = co_await watch.next();
  change = std::move(next);
  fetched.set();
}

}  // namespace

Task<Result<Revision>> Board::tell(Datum fact, std::vector<FactId> because) {
  Transaction transaction;
  transaction.tell(std::move(fact), std::move(because));
  return transact(std::move(transaction));
}

Task<Result<Revision>> Board::retract(Datum pattern) {
  Transaction transaction;
  transaction.retract(std::move(pattern));
  return transact(std::move(transaction));
}

Task<Result<std::vector<Fact>>> Board::facts(Datum pattern) {
  Query query = query_for(std::move(pattern));
  Result<Answers> answers = co_await ask(std::move(query));
  if (!answers) co_return fail(answers);
  std::vector<Fact> facts;
  facts.reserve(answers->answers.size());
  for (Answer& answer : answers->answers) facts.push_back(std::move(answer.facts.front()));
  co_return facts;
}

Result<Revision> if_it_stands(Result<Revision> told) {
  const bool stands = !told && told.error().symbol == "not-durable" && told.error().subject.is_integer();
  if (!stands) return told;
  return static_cast<Revision>(told.error().subject.integer());
}

Task<Result<Answer>> await_answer(Board& board, Query query, Time deadline, Executor& executor) {
  const Datum form = query_to_datum(query);
  Result<Answers> now = co_await board.ask(query);
  if (!now) co_return fail(now);
  if (!now->answers.empty()) co_return std::move(now->answers.front());
  Result<std::unique_ptr<Watch>> watch = co_await board.watch(std::move(query));
  if (!watch) co_return fail(watch);
  while (true) {
    std::optional<Result<Change>> change;
    Event fetched(executor);
    Task<void> fetching = fetch_next(**watch, change, fetched);
    const Job job = executor.spawn(std::move(fetching));
    const bool in_time = co_await fetched.wait(deadline);
    if (!in_time) co_return fail("timeout", "nothing on the board answered the query in time", form);
    if (!*change) co_return fail(change->error());
    std::vector<Answer>& added = (*change)->added;
    if (!added.empty()) co_return std::move(added.front());
  }
}

}  // namespace pizarra
