#pragma once

// How much each client may have the board look at. What it looks at for a client is that one's debt, which is paid by
// the time in which the board looks at nothing costly: all who owe share that time evenly. Who owes what two of the
// costliest questions take may look at few facts in a request until some is paid. While four owe so much, who owes less
// waits for a turn: one has what it asks looked at, then the next when that would be paid.
// Who is alone may go on: nobody waits. Of what it owes little is left when another asks.
//
//   LookQuota quota;
//   quota.asked(session, "alice", now);
//   const bool is_free = quota.standing("alice", now) == LookQuota::Standing::free;
//   const std::size_t before = is_free ? 0 : LookQuota::all_but_few;
//   std::size_t examined = before;                          // a search that goes on from there ends in time
//   ...
//   quota.looked("alice", examined - before, now);
//
// So what is looked at takes about half of the board's time at most, however many ask.

#include <map>
#include <optional>
#include <string>

#include "blackboard/limits.hpp"
#include "blackboard/time/clock.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/result.hpp"

namespace pizarra::server {

class LookQuota {
 public:
  // What a request looks at and nobody counts: it takes no more than the request itself.
  static constexpr std::size_t uncounted = 64;
  // What the search of who is spent goes on from.
  static constexpr std::size_t all_but_few = limits::examined - uncounted;
  static constexpr std::size_t paid_a_millisecond = 5000;
  static constexpr std::size_t most_owed = 2 * limits::examined;
  static constexpr std::size_t most_owed_by_all = 4 * most_owed;
  // By who was alone.
  static constexpr std::size_t most_kept = 2 * most_owed;

  // Whatever it is, before it is served.
  void asked(wire::SessionId session, const std::string& client, Time now);
  enum class Standing : std::uint8_t { free, waits, spent };
  Standing standing(const std::string& client, Time now);
  // Until now.
  void looked(const std::string& client, std::size_t examined, Time now);
  // The time until now was for others than those who owe, or for nobody: before something is looked at.
  void pay(Time now);
  // Failure too-many, of who is spent.
  static std::unexpected<Failure> refusal(const std::string& client);

 private:
  struct Asked {
    wire::SessionId session = 0;
    std::string client;
    std::optional<Time> when;
  };
  bool is_alone(const std::string& client, Time now) const;

  std::map<std::string, std::size_t> debts_;  // none is nothing
  std::size_t owed_by_all_ = 0;               // of each up to most_owed
  Time paid_until_{};
  Time next_turn_{};  // of who waits
  Asked newest_;
  std::optional<Time> other_asked_;  // when another session did
};

}  // namespace pizarra::server
