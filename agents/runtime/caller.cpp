#include "agents/runtime/caller.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/away.hpp"

namespace pizarra::runtime {

namespace {

constexpr Duration presence_look = 1s;

}  // namespace

// Tells the request and waits for its reply; tells it again when the caller's presence began anew, because a board that
// restarted has forgotten both.
Task<Result<Answer>> Caller::ask(Datum request, Time deadline, std::function<bool()> is_replaced) {
  const Query replied = query_for(list("reply"_sym, request[1], "?result"_sym));
  Result<Answer> answer = fail("timeout", "the time was over before the request was sent");
  while (context_.executor.now() < deadline) {
    const LeaseId presence = service_.presence();
    Transaction telling;
    telling.tell(request, {}, presence);
    const Result<Revision> told = co_await context_.board.transact(std::move(telling));
    if (!told) {
      const Failure& why = told.error();
      if (!is_away(why) && why.symbol != "unknown-lease") co_return fail(told);
      co_await sleep(context_.executor, retry_pause);
      continue;
    }
    bool waiting = true;
    bool replaced = false;
    while (waiting) {
      const Time look_up = std::min(deadline, context_.executor.now() + presence_look);
      answer = co_await await_answer(context_.board, replied, look_up, context_.executor);
      const bool in_vain = !answer && answer.error().symbol == "timeout";
      replaced = in_vain && is_replaced && is_replaced();
      waiting = in_vain && !replaced && look_up < deadline && service_.presence() == presence;
    }
    if (replaced) co_return fail("replaced", "nobody waits for this answer any more");
    const bool lost = !answer && (answer.error().symbol == "timeout" || is_away(answer.error()));
    if (!lost) co_return answer;
  }
  co_return answer;
}

Datum Caller::next_id() { return Datum::symbol(fmt::format("{}-{}-{}", context_.name, service_.presence(), ++count_)); }

Task<Result<Datum>> Caller::call(Callee callee, Datum operation, Duration timeout, Datum id) {
  const std::string& agent = callee.agent;
  if (!id.is_symbol()) id = next_id();
  const Datum request = list("request"_sym, id, Datum::symbol(agent), operation);
  const Time deadline = context_.executor.now() + timeout;
  const Result<Answer> answer = co_await ask(request, deadline, std::move(callee.is_replaced));
  Transaction clean_up;
  clean_up.retract(list("request"_sym, id, "?"_sym, "?"_sym));
  clean_up.retract(list("reply"_sym, id, "?"_sym));
  const Result<Revision> cleaned = co_await context_.board.transact(std::move(clean_up));
  if (!answer && answer.error().symbol == "timeout") {
    co_return fail("timeout", fmt::format("{} did not answer in {:.1f} s", agent, timeout.count() / 1e6), operation);
  }
  const bool replaced = !answer && answer.error().symbol == "replaced";
  if (replaced) co_return fail("replaced", agent + " is gone, and another serves in its place", operation);
  if (!answer) co_return fail(answer);
  if (!cleaned) co_return fail(cleaned);
  const Datum result = answer->facts.front().datum[2];
  if (result.is_form("fail")) co_return fail(failure_from_datum(result));
  if (!result.is_form("ok")) co_return fail("bad-reply", fmt::format("{} answered neither ok nor fail", agent), result);
  co_return Datum::list({result.items().begin() + 1, result.items().end()});
}

}  // namespace pizarra::runtime
