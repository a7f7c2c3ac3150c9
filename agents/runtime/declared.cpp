#include "agents/runtime/declared.hpp"

#include "agents/runtime/contract.hpp"
#include "blackboard/boards_own.hpp"

namespace pizarra::runtime {

namespace {

Task<Result<void>> until_declared(Board& board, std::string relation) {
  Result<bool> declared = co_await is_declared(board, relation);
  if (!declared) co_return fail(declared);
  if (*declared) co_return {};
  std::vector<Relation> shared = runtime_relations();
  const Result<void> ready = co_await board.declare(std::move(shared));
  if (!ready) co_return ready;
  const Query contracts = query_for(list("contract"_sym, "?name"_sym, "?form"_sym));
  const Result<std::unique_ptr<Watch>> coming = co_await board.watch(contracts);
  if (!coming) co_return fail(coming);
  while (true) {
    const Result<Change> change = co_await (*coming)->next();
    if (!change) co_return fail(change);
    declared = co_await is_declared(board, relation);
    if (!declared) co_return fail(declared);
    if (*declared) co_return {};
  }
}

}  // namespace

Task<Result<bool>> is_declared(Board& board, std::string relation) {
  if (is_made_up(relation)) co_return true;
  const Datum any = "?"_sym;
  Datum counts = list("relation-stats"_sym, Datum::symbol(relation), any, any, any, any, any, any);
  const Result<std::vector<Fact>> found = co_await board.facts(std::move(counts));
  if (found) co_return !found->empty();
  if (found.error().symbol == "not-permitted") co_return true;
  co_return fail(found);
}

Task<Result<std::vector<Fact>>> facts_if_declared(Board& board, Datum pattern) {
  const Result<bool> declared = co_await is_declared(board, std::string(pattern.head()));
  if (!declared) co_return fail(declared);
  if (!*declared) co_return std::vector<Fact>();
  co_return co_await board.facts(std::move(pattern));
}

Task<Result<Answers>> answers_if_declared(Board& board, Query query) {
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    const Result<bool> declared = co_await is_declared(board, std::string(clause.form.head()));
    if (!declared) co_return fail(declared);
    if (!*declared) co_return Answers();
  }
  co_return co_await board.ask(std::move(query));
}

Task<Result<std::unique_ptr<Watch>>> watch_when_declared(Board& board, Query query) {
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    const Result<void> declared = co_await until_declared(board, std::string(clause.form.head()));
    if (!declared) co_return fail(declared);
  }
  co_return co_await board.watch(std::move(query));
}

}  // namespace pizarra::runtime
