#include "agents/runtime/service.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>

#include "agents/runtime/naming.hpp"
#include "agents/runtime/own_name.hpp"
#include "blackboard/away.hpp"
#include "blackboard/teller.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::runtime {

namespace {

constexpr Duration presence_look = 1s;

Datum reply_datum(const Datum& id, const Result<Datum>& result) {
  if (!result) return list("reply"_sym, id, failure_to_datum(result.error()));
  std::vector<Datum> ok{"ok"_sym};
  ok.insert(ok.end(), result->items().begin(), result->items().end());
  return list("reply"_sym, id, Datum::list(std::move(ok)));
}

// A relation's other shape on the board most often comes from its journal.
Failure of_another_version(Failure failure) {
  failure.sentence += ", by another version of the agents: begin with a board, and a journal, of its own";
  return failure;
}

// Refusals that may pass with time.
bool may_pass(const Failure& failure) { return is_away(failure) || failure.symbol == "too-many"; }

}  // namespace

struct Service::Running {
  explicit Running(Executor& executor) : slot_freed(executor), announced(executor) {}

  static constexpr std::size_t remembered_replies = 256;
  void remember(const Datum& id, Datum reply) {
    replies.emplace(id, std::move(reply));
    replied.push_back(id);
    if (replied.size() <= remembered_replies) return;
    replies.erase(replied.front());
    replied.pop_front();
  }

  WaitList slot_freed;
  WaitList announced;  // under another lease than before
  bool leaving = false;
  std::map<Datum, Datum> replies;
  std::deque<Datum> replied;
  // Requests being done, by id, and the facts that they were last told as.
  std::map<Datum, FactId> in_hand;
  RequestHandler handler;
  Job renewal;
  std::vector<Job> jobs;
};

Service::Service(AgentContext& context, Contract contract)
    : context_(context), contract_(std::move(contract)), running_(std::make_unique<Running>(context.executor)) {}

Service::~Service() = default;

Task<Result<void>> Service::declare() {
  std::vector<Relation> relations = runtime_relations();
  relations.insert(relations.end(), contract_.posts.begin(), contract_.posts.end());
  relations.insert(relations.end(), contract_.reads.begin(), contract_.reads.end());
  while (true) {
    const Result<void> declared = co_await context_.board.declare(relations);
    if (declared) co_return declared;
    if (declared.error().symbol == "wrong-shape") co_return fail(of_another_version(declared.error()));
    if (!is_away(declared.error())) co_return declared;
    co_await sleep(context_.executor, retry_pause);
  }
}

Transaction Service::presence_facts(LeaseId lease) const {
  const Datum name = Datum::symbol(context_.name);
  Transaction presence;
  presence.tell(list("agent"_sym, name, Datum::symbol(contract_.kind), context_.host), {}, lease);
  presence.tell(list("contract"_sym, name, contract_.form), {}, lease);
  return presence;
}

// One try to stand on the board under the agent's name.
Task<Result<void>> Service::announce() {
  const Result<LeaseId> lease = co_await context_.board.lease(presence_lease);
  if (!lease) co_return fail(lease);
  Transaction presence = presence_facts(*lease);
  const Transaction::Absent vacancy{list("agent"_sym, Datum::symbol(context_.name), "?"_sym, "?"_sym)};
  presence.require(vacancy);
  const Result<Revision> told = co_await context_.board.transact(std::move(presence));
  if (told) {
    presence_ = *lease;
    running_->announced.wake_all();
    co_return {};
  }
  const Result<void> released = co_await context_.board.release(*lease);
  if (!released && told.error().symbol == "precondition-failed") co_return fail(released);
  co_return fail(told);
}

Task<Result<void>> Service::start() {
  const Result<void> declared = co_await declare();
  if (!declared) co_return declared;
  while (true) {
    const Result<void> announced = co_await announce();
    if (announced) break;
    const Failure& why = announced.error();
    // The name is held by a living agent, or by one whose lease has yet to lapse.
    if (why.symbol != "precondition-failed" && !is_away(why)) co_return announced;
    co_await sleep(context_.executor, retry_pause);
  }
  co_await bind_own_name();
  running_->renewal = context_.executor.spawn(keep_presence());
  co_return {};
}

// A key that was made for less need not let it; then nobody finds it by its kind, and who knows its name does.
Task<void> Service::bind_own_name() {
  if (contract_.offers.empty() || !may_bind_) co_return;
  if (!names_declared_) {
    std::vector<Relation> relations = naming_relations();
    const Result<void> declared = co_await context_.board.declare(std::move(relations));
    may_bind_ = declared || declared.error().symbol != "not-permitted";
    if (!declared) co_return;
    names_declared_ = true;
  }
  Transaction binding = own_binding(context_.name, contract_, presence_);
  const Result<Revision> bound = co_await context_.board.transact(std::move(binding));
  may_bind_ = bound || bound.error().symbol != "not-permitted";
}

Task<void> Service::keep_presence() {
  while (true) {
    co_await sleep(context_.executor, presence_renewal);
    const Result<void> renewed = co_await context_.board.renew(presence_);
    if (renewed) {
      // Told again, which changes nothing unless somebody retracted it: who lives is present. A renewal that fails is
      // tried again at the next one.
      Transaction presence = presence_facts(presence_);
      [[maybe_unused]] const Result<Revision> stands = co_await context_.board.transact(std::move(presence));
      co_await bind_own_name();
      continue;
    }
    if (renewed.error().symbol != "unknown-lease") continue;
    // The board forgot us (it restarted, or we were away too long); whoever took the name meanwhile keeps it.
    Result<void> announced = co_await announce();
    while (!announced) {
      co_await sleep(context_.executor, retry_pause);
      announced = co_await announce();
    }
    co_await bind_own_name();
  }
}

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
    const LeaseId presence = presence_;
    Result<std::optional<Fact>> taken = co_await context_.board.take(request, presence);
    const bool lapsed = !taken && taken.error().symbol == "unknown-lease";
    if (!lapsed) co_return taken;
    while (presence_ == presence) co_await running_->announced.wait();
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
  running_->renewal = Job();
  co_return co_await context_.board.release(presence_);
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

// Tells the request and waits for its reply; tells it again when the caller's presence began anew, because a board that
// restarted has forgotten both.
Task<Result<Answer>> Caller::ask(Datum request, Time deadline, GiveUp give_up) {
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
    bool given_up = false;
    while (waiting) {
      const Time look_up = std::min(deadline, context_.executor.now() + presence_look);
      answer = co_await await_answer(context_.board, replied, look_up, context_.executor);
      const bool in_vain = !answer && answer.error().symbol == "timeout";
      given_up = in_vain && give_up && give_up();
      waiting = in_vain && !given_up && look_up < deadline && service_.presence() == presence;
    }
    if (given_up) co_return fail("replaced", "nobody waits for this answer any more");
    const bool lost = !answer && (answer.error().symbol == "timeout" || is_away(answer.error()));
    if (!lost) co_return answer;
  }
  co_return answer;
}

Datum Caller::next_id() { return Datum::symbol(fmt::format("{}-{}-{}", context_.name, service_.presence(), ++count_)); }

Task<Result<Datum>> Caller::call(std::string agent, Datum operation, Duration timeout, GiveUp give_up, Datum id) {
  if (!id.is_symbol()) id = next_id();
  const Datum request = list("request"_sym, id, Datum::symbol(agent), operation);
  const Time deadline = context_.executor.now() + timeout;
  const Result<Answer> answer = co_await ask(request, deadline, std::move(give_up));
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
