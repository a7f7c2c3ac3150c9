#pragma once

// How much each client may have the board look at. What it looks at for a client is that one's debt, which is paid by
// the time in which the board looks at nothing costly: all who owe share that time evenly. Who owes what two of the
// costliest questions take, or anybody while four owe so much, may look at few facts in a request until some is paid.
//
//   LookQuota quota;
//   std::size_t examined = quota.before("alice", now);     // a search that goes on from there ends in time
//   ...
//   quota.looked("alice", examined - before, now);
//
// So what is looked at takes about half of the board's time at most, however many ask.

#include <map>
#include <string>

#include "blackboard/limits.hpp"
#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra {

class LookQuota {
 public:
  // What a request looks at and nobody counts: it takes no more than the request itself.
  static constexpr std::size_t uncounted = 64;
  static constexpr std::size_t paid_a_millisecond = 5000;
  static constexpr std::size_t most_owed = 2 * limits::examined;
  static constexpr std::size_t most_owed_by_all = 4 * most_owed;

  bool is_spent(const std::string& client, Time now);
  // What a request's search goes on from.
  std::size_t before(const std::string& client, Time now) {
    return is_spent(client, now) ? limits::examined - uncounted : 0;
  }
  // Until now.
  void looked(const std::string& client, std::size_t examined, Time now);
  // Failure too-many.
  static std::unexpected<Failure> refusal(const std::string& client);

 private:
  void pay(Time now);

  std::map<std::string, std::size_t> debts_;  // none is nothing
  std::size_t owed_by_all_ = 0;               // of each up to most_owed
  Time paid_until_{};
};

}  // namespace pizarra
