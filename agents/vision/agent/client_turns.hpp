#pragma once

// The turns of clients at the eyes, as they wait for them (turn_queue.hpp says in which order they come). A learning
// has no turn while somebody tracks.
//
//   ClientTurns turns(context, presence, holders);
//   const auto turn = co_await turns.take("planner", TurnQueue::Kind::brief);      // a Result; until it is destroyed
//   turns.wake();                                                                 // tracking has ended

#include "agents/vision/agent/client_presence.hpp"
#include "agents/vision/agent/turn_queue.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::vision {

class ClientTurns {
 public:
  static constexpr Duration longest_wait = 6s;  // for others; a learning takes two seconds

  class Turn {
   public:
    Turn(ClientTurns& turns, int number, TurnQueue::Kind kind, std::string client)
        : turns_(turns), number_(number), kind_(kind), client_(std::move(client)) {}
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();

   private:
    friend class ClientTurns;
    ClientTurns& turns_;
    int number_;
    TurnQueue::Kind kind_;
    std::string client_;
  };

  // All outlive it, and it outlives whoever waits.
  ClientTurns(runtime::AgentContext& context, ClientPresence& presence, const ModeHolders& holders)
      : context_(context), presence_(presence), holders_(holders), changed_(context.executor) {}

  // Waits until it comes. Failures: `busy`, its subject who holds what this excludes, or who asks for too much; and
  // `absent` for one that died meanwhile.
  Task<Result<std::unique_ptr<Turn>>> take(std::string client, TurnQueue::Kind kind);
  // Those who wait look again whether their turn has come.
  void wake() { changed_.wake_all(); }

 private:
  // False where it has to wait.
  Result<bool> begin(const Turn& turn);
  Task<Result<void>> wait_for(const Turn& turn);

  runtime::AgentContext& context_;
  ClientPresence& presence_;
  const ModeHolders& holders_;
  TurnQueue queue_;
  WaitList changed_;
};

}  // namespace pizarra::vision
