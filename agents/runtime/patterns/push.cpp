#include "agents/runtime/patterns/push.hpp"

#include <algorithm>

#include "lisp/reader.hpp"

namespace pizarra::runtime {

namespace {

Query pushes_of(const std::string& topic) {
  return query_for(list("pushed"_sym, Datum::symbol(topic), "?n"_sym, "?data"_sym));
}

Push push_of(const Answer& answer) {
  const Datum& fact = answer.facts.front().datum;
  return {fact[2].integer(), fact[3]};
}

Task<Result<void>> declare(Board& board) {
  const std::vector<Relation> relations{pushed_relation()};
  co_return co_await board.declare(relations);
}

}  // namespace

Relation pushed_relation() {
  return relation_from_datum(
             read_one("(relation pushed ((topic symbol) (n integer) (data datum)) (key topic))").value())
      .value();
}

Task<Result<void>> Publisher::push(Datum data) {
  const bool first = count_ == 0;
  if (first) {
    const Result<void> declared = co_await declare(context_.board);
    if (!declared) co_return declared;
  }
  Transaction telling;
  telling.tell(list("pushed"_sym, Datum::symbol(topic_), ++count_, std::move(data)), {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(telling));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Task<Result<Subscriber>> Subscriber::to(AgentContext& context, std::string topic) {
  const Result<void> declared = co_await declare(context.board);
  if (!declared) co_return fail(declared);
  Result<std::unique_ptr<Watch>> watch = co_await context.board.watch(pushes_of(topic));
  if (!watch) co_return fail(watch);
  co_return Subscriber(std::move(*watch));
}

Task<Result<Push>> Subscriber::next() {
  while (waiting_.empty()) {
    const Result<Change> change = co_await watch_->next();
    if (!change) co_return fail(change);
    for (const Answer& answer : change->added) waiting_.push_back(push_of(answer));
    std::ranges::sort(waiting_, std::ranges::greater(), &Push::number);
  }
  Push push = std::move(waiting_.back());
  waiting_.pop_back();
  co_return push;
}

Task<Result<Push>> pull(AgentContext& context, std::string topic, Time deadline) {
  const Result<void> declared = co_await declare(context.board);
  if (!declared) co_return fail(declared);
  const Result<Answer> answer = co_await await_answer(context.board, pushes_of(topic), deadline, context.executor);
  if (!answer) co_return fail(answer);
  co_return push_of(*answer);
}

}  // namespace pizarra::runtime
