#pragma once

// Roles: which agent serves a client in which of its needs, changeable while all of them run. A client names a role,
// and never the agent that plays it:
//
//   (wired CLIENT ROLE SERVER)            durable: who is to serve; anybody who may tell it changes it
//   (holder CLIENT ROLE SERVER STATE)     who does; the client tells it under its presence.
//                                         STATE: wired | stands-in | absent
//
// Where the server that is wired is away, or is not of the role's kind, the next in line stands in: the next by name of
// those bound in the role's context, (cell eyes) for the eyes. When the wired one is there again, it serves again.
//
//   Roles roles(context, service, {eyes_role(), planner_role()});
//   roles.start();
//   bool there = co_await roles.wait_for("eyes", deadline);
//   Result<Datum> seen = co_await caller.call(roles.player("eyes"), list("get-objects"_sym), 2s);
//
// Until somebody wires a role, its usual server is wired to it. A client that asks once, as a prompt does, asks
// holder_of().

#include <map>
#include <string>
#include <vector>

#include "agents/runtime/caller.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::runtime {

struct Role {
  std::string name;
  std::string kind;     // of those that can play it
  std::string context;  // in which they are bound, within (cell)
  std::string usual;    // who plays it where nobody is wired to it
};

Role robot_role();
Role eyes_role();
Role planner_role();
Role coordinator_role();

struct Holder {
  std::string server;
  std::string state;  // wired, stands-in, absent
  bool is_present() const { return state != "absent"; }
  bool operator==(const Holder&) const = default;
};

// wired, holder
std::vector<Relation> role_relations();

class Roles {
 public:
  // All outlive it.
  Roles(AgentContext& context, const Service& service, std::vector<Role> roles);

  // Declares, wires what is not wired to its usual server, and follows what is told. The service has started.
  void start();
  // The agent that plays it now. Before the board has answered: the usual one, absent.
  const Holder& holder(std::string_view role) const;
  // True once somebody plays it, false at the deadline.
  Task<bool> wait_for(std::string role, Time deadline);
  // Wakes when a role has another holder.
  WaitList& changed() { return changed_; }
  // Whoever plays it now, to be called. It is replaced once it is gone and another stands in: a call that is under way
  // stays with it until then. This outlives the call.
  Callee player(std::string role) const;

 private:
  using Take = void (Roles::*)(const Datum& fact, bool stands);
  struct Played {
    Role role;
    std::string wired;
    Holder holder;
  };

  Task<void> begin();
  Task<void> follow(Datum pattern, Take take);
  void forget_all(Take take);
  void take_agent(const Datum& fact, bool stands);
  void take_bound(const Datum& fact, bool stands);
  void take_wired(const Datum& fact, bool stands);
  void choose();
  Task<void> keep_told();

  AgentContext& context_;
  const Service& service_;
  std::vector<Played> played_;
  std::map<std::string, std::string> kinds_;               // of the agents that are present
  std::map<std::string, std::vector<std::string>> bound_;  // agents by context, in order
  int unanswered_ = 1;                                     // watches, before each has its first answer
  WaitList changed_;
  Job beginning_;
  std::vector<Job> jobs_;
};

// The holder of a client's role at this moment.
Task<Result<Holder>> holder_of(Board& board, std::string client, Role role);
// The same, once it is present: for as long as a presence lasts it may be that this board is yet to be told of it. A
// board that took over from another begins without presences.
Task<Result<Holder>> present_holder_of(AgentContext& context, std::string client, Role role);

}  // namespace pizarra::runtime
