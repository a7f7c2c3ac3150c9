#include "blackboard/cluster/standby.hpp"

#include "blackboard/cluster/log_upkeep.hpp"

namespace pizarra::cluster {

Result<bool> Standby::step(const std::function<Time()>& now) {
  const Result<std::size_t> came = followed_->follow();
  if (!came) return fail(came);
  // One who is far behind looks at the old first.
  if (followed_->is_behind()) return false;
  if (followed_->alive() != seen_) {
    seen_ = followed_->alive();
    seen_at_ = now();
    suspects_ = false;
  }
  vacant_ = !seen_ || seen_->leaves;
  if (!vacant_ && !suspects_ && now() < seen_at_ + suspects_after) return false;
  Result<std::optional<WonEpoch>> won = WonEpoch::campaign(key_values_, keys_, seen_, board_, nonce_);
  if (!won) {
    const bool sees_to_space = lacks_space(won.error()) && now() >= sees_to_space_at_;
    if (!sees_to_space) return fail(won);
    // No leader is there who would. It keeps all who use that etcd waiting, so it is done seldom.
    sees_to_space_at_ = now() + sees_to_space_every;
    const Result<void> space = make_space(key_values_);
    return fail(space ? won.error() : space.error());
  }
  if (!*won) return false;
  won_ = std::move(**won);
  return true;
}

Task<Result<void>> stand_by(Executor& executor, std::shared_ptr<Standby> standby, OnAttempt on_log) {
  using Work = std::function<void(const std::function<bool()>& cancelled)>;
  while (true) {
    const auto leads = std::make_shared<Result<bool>>(false);
    Work work = [standby, leads, &executor](const std::function<bool()>&) {
      *leads = standby->step([&executor] { return executor.now(); });
    };
    co_await executor.offload(std::move(work), Duration::zero());
    const Result<void> attempt = *leads ? Result<void>() : fail(*leads);
    const bool has_failed = !attempt && attempt.error().symbol != "unavailable";
    if (has_failed) co_return attempt;
    on_log(attempt);
    const bool has_won = attempt && leads->value();
    if (has_won) co_return attempt;
    co_await sleep(executor, looks_every);
  }
}

}  // namespace pizarra::cluster
