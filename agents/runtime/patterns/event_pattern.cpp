#include "agents/runtime/patterns/event_pattern.hpp"

#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra::runtime {

namespace {

Task<Result<void>> declare_events(Board& board) {
  const std::vector<Relation> relations{notice_relation()};
  co_return co_await board.declare(relations);
}

}  // namespace

Relation notice_relation() {
  return relation_from_datum(read_one("(relation notice ((id symbol) (client symbol) (form datum)) (key id))").value())
      .value();
}

Task<Result<void>> Notifier::notify(std::string client, Datum form) {
  const bool first = count_ == 0;
  if (first) {
    const Result<void> declared = co_await declare_events(context_.board);
    if (!declared) co_return declared;
  }
  const Datum id = Datum::symbol(fmt::format("{}-{}-{}", context_.name, service_.presence(), ++count_));
  Transaction telling;
  telling.tell(list("notice"_sym, id, Datum::symbol(client), std::move(form)), {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(telling));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Task<Result<Datum>> next_event(AgentContext& context, Time deadline) {
  const Result<void> declared = co_await declare_events(context.board);
  if (!declared) co_return fail(declared);
  const Datum mine = list("notice"_sym, "?id"_sym, Datum::symbol(context.name), "?form"_sym);
  while (true) {
    const Result<std::optional<Fact>> taken = co_await context.board.take(mine, 0);
    if (!taken) co_return fail(taken);
    if (*taken) co_return (*taken)->datum[3];
    const Result<Answer> there = co_await await_answer(context.board, query_for(mine), deadline, context.executor);
    if (!there) co_return fail(there);
  }
}

}  // namespace pizarra::runtime
