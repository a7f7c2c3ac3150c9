#pragma once

// The epoch by which one of a cell's boards leads, and for how long that board may answer.
//
//   Result<std::optional<WonEpoch>> won = WonEpoch::campaign(key_values, keys, copy.alive(), "board-pc", nonce);
//   LastConfirmation last;
//   const Duration sent = uptime();                                     // every confirms_every
//   Result<Revision> up_to = won->confirm(key_values, now, revision, fact);
//   if (up_to) last.confirmed(sent, *up_to);
//   if (last.may_answer(uptime(), revision)) ...                        // before each reply
//
// A board leads by its epoch: a key that every transaction of its log compares. Taking the lead replaces the epoch
// where the leader has not confirmed it since it was seen. The old one's appends fail from then on; its answers end by
// themselves `answers_for` after the last confirmation that went through was sent, and the new one serves
// `serves_after` it saw that one. The clocks of both only need to run at about the same speed, and the leader's also
// while its machine is suspended (uptime.hpp).

#include <optional>

#include "blackboard/cluster/log_keys.hpp"

namespace pizarra::cluster {

inline constexpr Duration confirms_every = 100ms;
inline constexpr Duration answers_for = 250ms;
inline constexpr Duration serves_after = 300ms;
// Without a sign of life, who stands by takes the lead.
inline constexpr Duration suspects_after = 220ms;

// Behind every time of an answer by the leader that said this last.
Time time_behind(const Alive& said);

// A leader's last confirmation, by its machine's uptime: it tells until when the leader may answer.
class LastConfirmation {
 public:
  void confirmed(Duration sent, Revision up_to) {
    sent_ = sent;
    up_to_ = up_to;
  }
  bool may_answer(Duration now, Revision revision) const {
    return sent_ && now < *sent_ + answers_for && revision <= up_to_;
  }
  const std::optional<Duration>& sent() const { return sent_; }

 private:
  std::optional<Duration> sent_;
  Revision up_to_ = 0;
};

class WonEpoch {
 public:
  // How many revisions and fact numbers a board may use before it announces the next ones: far more than it can.
  static constexpr std::uint64_t reserve = std::uint64_t{1} << 32;

  // `seen`: what the leader said last, if there is one. Nothing where another was faster, or the leader lives.
  // Failure unavailable: whether it leads now is found out by campaigning again with the same nonce.
  static Result<std::optional<WonEpoch>> campaign(KeyValues& key_values, const LogKeys& keys,
                                                  const std::optional<Alive>& seen, const std::string& board,
                                                  std::uint64_t nonce);

  const EpochValue& value() const { return epoch_; }
  // Beyond any revision, and any fact, of those who led before.
  Revision first_revision() const { return first_revision_; }
  FactId first_fact() const { return first_fact_; }

  // That it leads on, and up to which revision it may go. Failures unavailable, and deposed: another leads.
  Result<Revision> confirm(KeyValues& key_values, Time now, Revision revision, FactId fact,
                           Duration wait = 2 * confirms_every);
  // That it answers nobody any more.
  Result<void> resign(KeyValues& key_values, Time now);

 private:
  WonEpoch(LogKeys keys, EpochValue epoch, Alive alive)
      : keys_(std::move(keys)),
        epoch_(std::move(epoch)),
        alive_(alive),
        first_revision_(alive.revision - reserve),
        first_fact_(alive.fact - reserve) {}
  static Result<std::optional<WonEpoch>> found(KeyValues& key_values, const LogKeys& keys, std::uint64_t nonce);
  Result<void> say(KeyValues& key_values, const Alive& alive, Duration wait);

  LogKeys keys_;
  EpochValue epoch_;
  Alive alive_;
  Revision first_revision_;
  FactId first_fact_;
};

}  // namespace pizarra::cluster
