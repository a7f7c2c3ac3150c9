#include "agents/runtime/patterns/send.hpp"

#include <fmt/format.h>

namespace pizarra::runtime {

Task<Result<void>> Sender::send(std::string agent, Datum operation) {
  // Apart from the ids of those that are waited for (Caller).
  const Datum id = Datum::symbol(fmt::format("{}-{}-send-{}", context_.name, service_.presence(), ++count_));
  Transaction telling;
  telling.tell(list("request"_sym, id, Datum::symbol(agent), operation), {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(telling));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

}  // namespace pizarra::runtime
