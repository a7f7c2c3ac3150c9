#include "agents/runtime/service.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>

#include "blackboard/away.hpp"
#include "blackboard/teller.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::runtime {

namespace {

Datum reply_datum(const Datum& id, const Result<Datum>& result) {
  if (!result) return list("reply"_sym, id, failure_to_datum(result.error()));
  std::vector<Datum> ok{"ok"_sym};
  ok.insert(ok.end(), result->items().begin(), result->items().end());
  return list("reply"_sym, id, Datum::list(std::move(ok)));
}

// Refusals that may pass with time.
bool may_pass(const Failure& failure) { return is_away(failure) || failure.symbol == "too-many"; }

}  // namespace

struct Service::Running {
  explicit Running(Executor& executor) : slot_freed(executor) {}

  static constexpr std::size_t remembered_replies = 256;
  void remember(const Datum& id, Datum reply) {
    replies.emplace(id, std::move(reply));
    replied.push_back(id);
    if (replied.size() <= remembered_replies) return;
    replies.erase(replied.front());
    replied.pop_front();
  }

  WaitList slot_freed;
  bool leaving = false;
  std::map<Datum, Datum> replies;
  std::deque<Datum> replied;
  // Requests being done, by id, and the facts that they were last told as.
  std::map<Datum, FactId> in_hand;
  RequestHandler handler;
  std::vector<Job> jobs;
};

Service::Service(AgentContext& context, Contract contract)
    : context_(context),
      contract_(std::move(contract)),
      presence_(context, contract_),
      running_(std::make_unique<Running>(context.executor)) {}

Service::~Service() = default;

Task<Result<void>> Service::serve(Handler handler) {
  return serve_requests([handler = std::move(handler)](Fact request) { return handler(request.datum[3]); });
}

Task<Result<void>> Service::serve_requests(RequestHandler handler) {
  running_->handler = std::move(handler);
  const Query requests = query_for(list("request"_sym, "?id"_sym, Datum::symbol(context_.name), "?operation"_sym));
  while (true) {
    const Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(requests);
    if (!watch && !may_pass(watch.error())) co_return fail(watch);
    if (watch) {
      const Result<void> ended = co_await follow(**watch);
      if (!ended && !may_pass(ended.error())) co_return ended;
    }
    co_await sleep(context_.executor, retry_pause);
  }
}

// Takes and starts every request that the watch shows, until the watch fails.
Task<Result<void>> Service::follow(Watch& watch) {
  while (true) {
    const Result<Change> change = co_await watch.next();
    if (!change) co_return fail(change);
    for (const Answer& answer : change->added) {
      std::erase_if(running_->jobs, [](const Job& job) { return job.done(); });
      while (running_->jobs.size() >= max_concurrent) {
        co_await running_->slot_freed.wait();
        std::erase_if(running_->jobs, [](const Job& job) { return job.done(); });
      }
      if (running_->leaving) continue;
      const Datum request = answer.facts.front().datum;
      const Result<std::optional<Fact>> taken = co_await take(request);
      if (!taken) co_return fail(taken);
      if (*taken) running_->jobs.push_back(context_.executor.spawn(answer_request(**taken)));
    }
  }
}

// Who is not present takes nothing: where the lease has lapsed, the request waits for the next one.
Task<Result<std::optional<Fact>>> Service::take(Datum request) {
  while (true) {
    const LeaseId lease = presence_.lease();
    Result<std::optional<Fact>> taken = co_await context_.board.take(request, lease);
    const bool lapsed = !taken && taken.error().symbol == "unknown-lease";
    if (!lapsed) co_return taken;
    co_await presence_.until_replaced(lease);
  }
}

Task<Result<void>> Service::leave(Duration patience) {
  running_->leaving = true;
  const Time deadline = context_.executor.now() + patience;
  bool in_time = true;
  while (in_time) {
    if (running_->in_hand.empty()) break;
    in_time = co_await running_->slot_freed.wait(deadline);
  }
  Result<void> ended = co_await presence_.end();
  co_return ended;
}

Task<void> Service::answer_request(Fact request) {
  const Datum id = request.datum[1];
  const bool again = running_->in_hand.contains(id);
  running_->in_hand[id] = request.id;
  // Told again while it is being done, because its caller or the board was away: the newest fact is the one to settle.
  if (again) co_return;

  const auto remembered = running_->replies.find(id);
  Datum reply;
  if (remembered != running_->replies.end()) {
    reply = remembered->second;
  } else {
    reply = co_await work_out(request);
    running_->remember(id, reply);
  }
  const Result<Revision> told = co_await deliver(reply);
  // A reply that the board refuses (too large, or with a variable in it) must not leave the caller waiting. When the
  // request is not held any more, its next taker answers it.
  const bool refused = !told && told.error().symbol != "precondition-failed";
  if (refused) {
    const Failure failure{"bad-reply", "the board refused the answer: " + told.error().sentence, {}, {}};
    const Datum excuse = list("reply"_sym, id, failure_to_datum(failure));
    const Result<Revision> excused = co_await deliver(excuse);
    if (excused) running_->replies[id] = excuse;
  }
  running_->in_hand.erase(id);
  running_->slot_freed.wake_all();
}

Task<Datum> Service::work_out(Fact request) {
  const Datum id = request.datum[1];
  // No board lets such a client in, but a journal of an earlier version may hold what one asked.
  const Result<void> named = check_teller_name(request.teller);
  if (!named) co_return reply_datum(id, fail(named));
  const Result<void> offered = check_operation(contract_, request.datum[3]);
  if (!offered) co_return reply_datum(id, fail(offered));
  const Result<Datum> result = co_await running_->handler(std::move(request));
  co_return reply_datum(id, result);
}

Task<Result<Revision>> Service::deliver(Datum reply) {
  while (true) {
    const FactId cause = running_->in_hand.at(reply[1]);
    Transaction transaction;
    transaction.tell(reply, {cause}).settle(cause);
    const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
    const bool retold = running_->in_hand.at(reply[1]) != cause;
    const bool ended = told || (!is_away(told.error()) && !retold);
    if (ended) co_return told;
    co_await sleep(context_.executor, retry_pause);
  }
}

}  // namespace pizarra::runtime
