#include "agents/runtime/patterns/wiring.hpp"

#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra::runtime {

namespace {

Task<Result<void>> declare_wiring(Board& board) {
  const std::vector<Relation> relations{wired_relation()};
  co_return co_await board.declare(relations);
}

Datum wired(const std::string& client, const std::string& role, Datum server) {
  return list("wired"_sym, Datum::symbol(client), Datum::symbol(role), std::move(server));
}

}  // namespace

Relation wired_relation() {
  constexpr std::string_view form =
      "(relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))";
  return relation_from_datum(read_one(form).value()).value();
}

Task<Result<void>> wire(Board& board, std::string client, std::string role, std::string server) {
  const Result<void> declared = co_await declare_wiring(board);
  if (!declared) co_return declared;
  const Datum fact = wired(client, role, Datum::symbol(server));
  const Result<Revision> told = co_await board.tell(fact);
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Task<Result<void>> unwire(Board& board, std::string client, std::string role) {
  const Result<void> declared = co_await declare_wiring(board);
  if (!declared) co_return declared;
  const Datum pattern = wired(client, role, "?"_sym);
  const Result<Revision> retracted = co_await board.retract(pattern);
  if (!retracted) co_return fail(retracted);
  co_return Result<void>();
}

Task<Result<Datum>> Wired::call(Datum operation, Duration patience) {
  const Result<void> declared = co_await declare_wiring(context_.board);
  if (!declared) co_return fail(declared);
  const Time deadline = context_.executor.now() + patience;
  const Query server = query_for(wired(context_.name, role_, "?server"_sym));
  const Result<Answer> answer = co_await await_answer(context_.board, server, deadline, context_.executor);
  const bool nobody = !answer && answer.error().symbol == "timeout";
  if (nobody) {
    co_return fail("not-wired", fmt::format("nobody is wired to {} as {}", context_.name, role_), Datum::symbol(role_));
  }
  if (!answer) co_return fail(answer);
  const std::string name(answer->facts.front().datum[3].text());
  const Duration left = deadline - context_.executor.now();
  co_return co_await caller_.call(name, operation, left);
}

}  // namespace pizarra::runtime
