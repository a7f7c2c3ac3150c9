#pragma once

// Turns of clients at the board's costly requests. One client has a turn at a time, however many sessions it has. After
// a turn everybody is heard for as long as the turn took; where only one session speaks, no such rest is needed.
//
//   turns.heard(session);                         // whatever it says
//   if (!turns.is_free(now)) turns.wait(client, session);
//   ...
//   turns.took(session, examined, now);           // so many facts were looked at for it
//   while (!turns.empty() && !turns.is_resting(now)) serve(turns.next());
//
// So costly questions take half of the board's time at most while others speak, and nobody waits for more than one.

#include <deque>
#include <map>
#include <string>

#include "blackboard/time/clock.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

class CostlyTurns {
 public:
  // The work that a request may do out of its turn: a tenth of a millisecond.
  static constexpr std::size_t out_of_turn = 1000;
  static constexpr std::size_t looks_a_us = 10;

  void heard(wire::SessionId session) { others_were_heard_ = others_were_heard_ || session != newest_; }
  void took(wire::SessionId session, std::size_t examined, Time now);
  bool is_resting(Time now) const { return others_were_heard_ && now < rested_; }
  Time rested() const { return rested_; }
  // Whether nobody waits, and a turn may begin at once.
  bool is_free(Time now) const { return waiting_.empty() && !is_resting(now); }

  // Behind what waits of its client.
  void wait(const std::string& client, wire::SessionId session);
  bool empty() const { return waiting_.empty(); }
  std::size_t clients() const { return waiting_.size(); }
  // Of the next client; it must not be empty.
  wire::SessionId next();

 private:
  std::map<std::string, std::deque<wire::SessionId>> waiting_;
  std::string last_client_;
  wire::SessionId newest_ = 0;  // that had a turn
  bool others_were_heard_ = false;
  Time rested_{};
};

}  // namespace pizarra::server
