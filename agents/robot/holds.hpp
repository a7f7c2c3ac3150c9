#pragma once

// Motions that last only while a client holds on. CLIENT itself tells `(hold ROBOT CLIENT COUNT)` while it has its hand
// on the arm, again and again with another COUNT. A hold that is not renewed within the motion's deadline stops the
// arm: the motion fails. A hold that is retracted stops it too: the motion has ended well. A hold moves nothing by
// itself, so one that comes late moves nothing either.
//
// Lifecycle: constructed beside the ArmControl; begin() once the relation is declared; a Watching for as long as a jog
// is in hand.
//
//   const Result<void> held = co_await holds.await("console-7-1", 250ms);      // or not-held
//   const Holds::Watching watching(holds, "console-7-1", 250ms);
//   co_await control.follow(...);                                               // `released` is no failure of it

#include <map>
#include <string>

#include "agents/robot/arm_control.hpp"

namespace pizarra::robot {

class Holds {
 public:
  // The symbol of follow()'s failure where the hold was retracted.
  static constexpr std::string_view released = "released";

  Holds(runtime::AgentContext& context, ArmControl& control)
      : context_(context), control_(control), heard_(context.executor) {}

  // Follows the holds on the board from now on.
  void begin();
  // Until there is one of `client` that is younger than `deadline`; for so long at most. Failure: not-held.
  Task<Result<void>> await(std::string client, Duration deadline);

  class Watching {
   public:
    Watching(Holds& holds, std::string client, Duration deadline);
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    ~Watching() { holds_.client_.clear(); }

   private:
    Holds& holds_;
    Job listening_;
  };

 private:
  struct Hold {
    FactId fact;
    Datum count;
    Time renewed;
  };

  Task<void> take(Change change);
  void see(const Change& change);
  void add(const Fact& fact);
  void remove(const Fact& fact);
  void gone(const std::string& client);
  Task<void> listen(Duration deadline);
  bool is_fresh(const std::string& client, Duration deadline) const;

  runtime::AgentContext& context_;
  ArmControl& control_;
  std::map<std::string, Hold> holds_;
  std::string client_;  // whose jog is in hand
  WaitList heard_;
  Job following_;
};

}  // namespace pizarra::robot
