#pragma once

// Stops an arm by itself at four events, and decides who may command it. The events:
//
//   - anyone tells a fact `(stop WHO REASON)`: the motion in hand ends, and none begins while such a fact stands;
//   - the board has not answered for four beats of the reflex's own timer (80 ms);
//   - the client whose motion it is loses its `(agent ...)` presence, or its `(commander ROBOT CLIENT)`;
//   - another client becomes the commander.
//
// A client that itself tells `(commander ROBOT CLIENT)` and is present is the commander; of several, the one that told
// it first. While there is none, anyone may move the arm, except clients that tell it and are not present. Monitoring
// and stopping are open to all. A stopped motion goes on only when it is asked for again.
//
// Lifecycle: constructed beside the ArmControl; begin() once the relations are declared; known() before anybody is
// obeyed; a Watching for as long as a motion is in hand.
//
//   if (const Result<void> allowed = reflex.allows(client); !allowed) co_return fail(allowed);
//   const Reflex::Watching watching(reflex, client, lease);

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "agents/robot/arm_control.hpp"

namespace pizarra::robot {

class Reflex {
 public:
  static constexpr Duration beat = 20ms;
  static constexpr int silent_beats = 4;

  Reflex(runtime::AgentContext& context, ArmControl& control)
      : context_(context), control_(control), more_heard_(context.executor) {}

  // Follows stops, commanders and presences on the board from now on.
  void begin();
  // Answers when the board has said of each of them what holds.
  Task<void> known();
  // Whether `client` may move or change anything now. Failures: `halted`, `not-commander`, each with who is in the
  // way; `not-present`.
  Result<void> allows(const std::string& client) const;

  // For as long as a motion is in hand that `client` asked for: beats on the board under the agent's `lease`, and stops
  // the arm where what allowed the motion ends.
  class Watching {
   public:
    Watching(Reflex& reflex, std::string client, LeaseId lease);
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    ~Watching() { reflex_.client_.reset(); }

   private:
    Reflex& reflex_;
    Job beating_;
  };

 private:
  Task<void> take(std::string relation, Change change);
  void see(const std::string& relation, const Change& change);
  void forget(const std::string& relation);
  void add(const Fact& fact);
  void remove(const Fact& fact);
  void gone(const std::string& client);
  const std::string* commander() const;
  void hand_over();
  Task<void> beat_on(LeaseId lease);
  Task<void> ask_board(LeaseId lease);

  runtime::AgentContext& context_;
  ArmControl& control_;
  std::map<FactId, Datum> stops_;
  std::map<FactId, std::string> commanders_;  // the first commands
  std::map<FactId, std::string> present_;
  std::optional<std::string> client_;  // whose motion is in hand
  bool leased_ = false;                // it was present when its motion began
  std::set<std::string> heard_;        // the relations whose first answer has come
  WaitList more_heard_;
  std::vector<Job> following_;
  int silence_ = 0;  // beats since the board answered
};

}  // namespace pizarra::robot
