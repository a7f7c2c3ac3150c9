#include "blackboard/cluster/log_leader.hpp"

#include <algorithm>

#include "blackboard/cluster/log_upkeep.hpp"

namespace pizarra::cluster {

namespace {

using Work = std::function<void(const std::function<bool()>& cancelled)>;

bool is_unavailable(const Failure& failure) { return failure.symbol == "unavailable"; }

}  // namespace

LogLeader::LogLeader(Executor& executor, Needs needs, LogKeys keys, std::shared_ptr<Standby> standby, Duration waits)
    : executor_(executor),
      needs_(std::move(needs)),
      keys_(std::move(keys)),
      standby_(std::move(standby)),
      epoch_(std::make_shared<WonEpoch>(standby_->take_epoch())),
      serves_at_(executor_.now() + waits) {}

Result<std::shared_ptr<KeyValues>> LogLeader::connect() {
  Result<std::shared_ptr<KeyValues>> connected = needs_.connect();
  if (!connected) end(connected.error());
  return connected;
}

bool LogLeader::may_answer() const {
  return !ended_ && !leaves_ && confirmation_.may_answer(needs_.uptime(), counters().revision);
}

std::optional<Duration> LogLeader::age() const {
  if (ended_ || leaves_ || !confirmation_.sent()) return std::nullopt;
  return needs_.uptime() - *confirmation_.sent();
}

void LogLeader::end(const Failure& failure) {
  ended_ = failure;
  needs_.on_end();
}

Task<void> LogLeader::confirm() {
  const Result<std::shared_ptr<KeyValues>> store = connect();
  if (!store) co_return;
  while (!leaves_) {
    const Duration sent = needs_.uptime();
    const Time now = executor_.now();
    const auto up_to = std::make_shared<Result<Revision>>(Revision{0});
    Work work = [store = *store, epoch = epoch_, up_to, now, used = counters()](auto&&) {
      *up_to = epoch->confirm(*store, now, used.revision, used.fact);
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    heard(*up_to, sent);
    if (ended_) co_return;
    co_await sleep(executor_, std::max(now + confirms_every - executor_.now(), Duration(1000)));
  }
  // Whoever stands by need not wait.
  Work resign = [store = *store, epoch = epoch_, now = executor_.now()](auto&&) { (void)epoch->resign(*store, now); };
  co_await executor_.offload(std::move(resign), Duration::zero());
}

void LogLeader::heard(const Result<Revision>& up_to, Duration sent) {
  if (up_to) confirmation_.confirmed(sent, *up_to);
  if (!up_to && !is_unavailable(up_to.error())) return end(up_to.error());
  needs_.on_log(up_to ? Result<void>() : fail(up_to));
}

Task<void> LogLeader::catch_up() {
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
    if (!is_unavailable(failure)) co_return end(failure);
    needs_.on_log(*whole);
    co_await sleep(executor_, looks_every);
  }
}

Result<LogLeader::Begun> LogLeader::begin(const std::string& path) {
  const Result<std::shared_ptr<KeyValues>> writing = connect();
  if (!writing) return fail(writing);
  const Result<std::shared_ptr<KeyValues>> reading = connect();
  if (!reading) return fail(reading);
  FollowedLog& followed = standby_->followed();
  Begun begun;
  begun.log = std::make_shared<ClusterLog>(*writing, *reading, keys_, epoch_->value(), followed.number(), path,
                                           followed.weight());
  begun.replies = followed.replies();
  begun.store = followed.take_store();
  begun.store->restore_counters(epoch_->first_revision(), epoch_->first_fact());
  space_ = begun.log->space();
  return begun;
}

Task<void> LogLeader::until_it_serves() {
  const Duration rest = std::max(serves_at_ - executor_.now(), Duration::zero());
  co_await sleep(executor_, rest);
}

Task<void> LogLeader::keep_in_space() {
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
