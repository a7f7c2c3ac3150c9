#include "blackboard/cluster/lead.hpp"

#include <algorithm>

#include "blackboard/cluster/log_upkeep.hpp"

namespace pizarra::cluster {

namespace {

using Work = std::function<void(const std::function<bool()>& cancelled)>;

bool passes(const Failure& failure) { return failure.symbol == "unavailable"; }

}  // namespace

Task<Result<void>> stand_by(Executor& executor, std::shared_ptr<Standby> standby, OnAttempt on_log) {
  while (true) {
    const auto leads = std::make_shared<Result<bool>>(false);
    Work work = [standby, leads, &executor](const std::function<bool()>&) {
      *leads = standby->step([&executor] { return executor.now(); });
    };
    co_await executor.offload(std::move(work), Duration::zero());
    const Result<void> attempt = *leads ? Result<void>() : fail(*leads);
    const bool has_failed = !attempt && !passes(attempt.error());
    if (has_failed) co_return attempt;
    on_log(attempt);
    const bool has_won = attempt && leads->value();
    if (has_won) co_return attempt;
    co_await sleep(executor, looks_every);
  }
}

Lead::Lead(Executor& executor, Needs needs, LogKeys keys, std::shared_ptr<Standby> standby, Duration waits)
    : executor_(executor),
      needs_(std::move(needs)),
      keys_(std::move(keys)),
      standby_(std::move(standby)),
      leadership_(std::make_shared<Leadership>(standby_->take_leadership())),
      serves_at_(executor_.now() + waits) {}

Result<std::shared_ptr<KeyValues>> Lead::connect() {
  Result<std::shared_ptr<KeyValues>> connected = needs_.connect();
  if (!connected) end(connected.error());
  return connected;
}

bool Lead::may_answer() const { return !ended_ && !leaves_ && term_.may_answer(needs_.uptime(), counters().revision); }

std::optional<Duration> Lead::age() const {
  if (ended_ || leaves_ || !term_.sent()) return std::nullopt;
  return needs_.uptime() - *term_.sent();
}

void Lead::end(const Failure& failure) {
  ended_ = failure;
  needs_.on_end();
}

Task<void> Lead::confirm() {
  const Result<std::shared_ptr<KeyValues>> store = connect();
  if (!store) co_return;
  while (!leaves_) {
    const Duration sent = needs_.uptime();
    const Time now = executor_.now();
    const auto up_to = std::make_shared<Result<Revision>>(Revision{0});
    Work work = [store = *store, leadership = leadership_, up_to, now, used = counters()](auto&&) {
      *up_to = leadership->confirm(*store, now, used.revision, used.fact);
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    heard(*up_to, sent);
    if (ended_) co_return;
    co_await sleep(executor_, std::max(now + confirms_every - executor_.now(), Duration(1000)));
  }
  // Whoever stands by need not wait.
  Work resign = [store = *store, leadership = leadership_, now = executor_.now()](auto&&) {
    (void)leadership->resign(*store, now);
  };
  co_await executor_.offload(std::move(resign), Duration::zero());
}

void Lead::heard(const Result<Revision>& up_to, Duration sent) {
  if (up_to) term_.confirmed(sent, *up_to);
  if (!up_to && !passes(up_to.error())) return end(up_to.error());
  needs_.on_log(up_to ? Result<void>() : fail(up_to));
}

Task<void> Lead::catch_up() {
  const Result<std::shared_ptr<KeyValues>> store = connect();
  while (store && !ended_) {
    const auto whole = std::make_shared<Result<void>>();
    Work work = [store = *store, keys = keys_, standby = standby_, whole](auto&&) {
      const Result<std::optional<std::uint64_t>> head = head_of(*store, keys);
      *whole = head ? standby->followed().follow_to(head->value_or(0)) : fail(head);
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    if (*whole) co_return;
    const Failure& failure = whole->error();
    if (!passes(failure)) co_return end(failure);
    needs_.on_log(*whole);
    co_await sleep(executor_, looks_every);
  }
}

Result<Lead::Begun> Lead::begin(const std::string& path) {
  const Result<std::shared_ptr<KeyValues>> writing = connect();
  if (!writing) return fail(writing);
  const Result<std::shared_ptr<KeyValues>> reading = connect();
  if (!reading) return fail(reading);
  FollowedLog& followed = standby_->followed();
  Begun begun;
  begun.log = std::make_shared<ClusterLog>(*writing, *reading, keys_, leadership_->epoch(), followed.number(), path,
                                           followed.weight());
  begun.replies = followed.replies();
  begun.store = followed.take_store();
  begun.store->restore_counters(leadership_->first_revision(), leadership_->first_fact());
  space_ = begun.log->space();
  return begun;
}

Task<void> Lead::until_it_serves() {
  const Duration rest = std::max(serves_at_ - executor_.now(), Duration::zero());
  co_await sleep(executor_, rest);
}

Task<void> Lead::keep_in_space() {
  const Result<std::shared_ptr<KeyValues>> store = connect();
  if (!store) co_return;
  const auto upkeep = std::make_shared<LogUpkeep>(*store, keys_, space_);
  while (true) {
    co_await sleep(executor_, upkeep_every);
    const auto kept = std::make_shared<Result<void>>();
    Work work = [upkeep, kept, now = executor_.now(), nonce = needs_.nonce()](auto&&) {
      *kept = upkeep->step(now, nonce);
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    // What could not be done now is tried again.
    needs_.on_upkeep(*kept);
  }
}

}  // namespace pizarra::cluster
