#pragma once

// A board that stands by: it follows the log, and takes the lead where nobody has it.
//
//   Standby standby(key_values, keys, "board-pc", nonce, now());
//   Result<bool> leads = standby.step(now);             // every 40 ms; failures unavailable, bad-journal
//   if (leads && *leads) ... standby.take_epoch(), standby.followed()
//
// A nonce is another one for every life of a board.

#include <algorithm>
#include <functional>
#include <memory>

#include "blackboard/cluster/followed_log.hpp"
#include "blackboard/cluster/won_epoch.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::cluster {

inline constexpr Duration looks_every = 40ms;
inline constexpr Duration sees_to_space_every = 30s;

class Standby {
 public:
  Standby(KeyValues& key_values, LogKeys keys, std::string board, std::uint64_t nonce, Time now)
      : key_values_(key_values),
        keys_(std::move(keys)),
        board_(std::move(board)),
        nonce_(nonce),
        followed_(std::make_unique<FollowedLog>(key_values_, keys_)),
        seen_at_(now) {}

  // Whether it leads now.
  Result<bool> step(const std::function<Time()>& now);
  // Suspects who leads, whatever it says.
  void suspect() { suspects_ = true; }

  FollowedLog& followed() { return *followed_; }
  // Where the time of a board that takes the lead begins at the earliest: behind the log and behind all answers of the
  // former leader, whose clock may be ahead.
  Time earliest_time() const { return std::max(followed_->end().when, seen_ ? time_behind(*seen_) : Time()); }
  WonEpoch take_epoch() { return std::move(*won_); }
  // How long whoever led before may still answer. Its last confirmation was sent before it was seen here, and taking
  // the lead compared it. Nothing where nobody led, or who did said that it answers no more.
  Duration must_wait(Time now) const {
    return vacant_ ? Duration::zero() : std::max(seen_at_ + serves_after - now, Duration::zero());
  }

 private:
  KeyValues& key_values_;
  const LogKeys keys_;
  const std::string board_;
  const std::uint64_t nonce_;
  std::unique_ptr<FollowedLog> followed_;
  std::optional<Alive> seen_;
  Time seen_at_;
  Time sees_to_space_at_{};
  bool suspects_ = false;
  bool vacant_ = false;
  std::optional<WonEpoch> won_;
};

// How each attempt went: a failure, or that the log answers.
using OnAttempt = std::function<void(const Result<void>&)>;

// Steps until it leads. It fails with any failure but `unavailable`, which passes by waiting.
Task<Result<void>> stand_by(Executor& executor, std::shared_ptr<Standby> standby, OnAttempt on_log);

}  // namespace pizarra::cluster
