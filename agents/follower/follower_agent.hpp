#pragma once

// Has one arm, the slave, follow another, the master, through facts alone: it watches where the master's agent says its
// grip centre is, and sends the slave's there in straight moves, by the robot interface. The slave keeps its reflexes,
// its limits and its tool's direction. Nothing is extrapolated: where the master's facts end, so does the way. The two
// are those that play its roles `master` and `slave` when it is asked to follow.
//
//   resting --(follow)--> following <----> limited        limited: the slave cannot go there, DETAIL says why
//   following, limited --(rest)--> resting
//   following, limited --one of them fails, or another takes its role--> broken --(follow)--> following
//
// While it follows it is the slave's commander. It goes on by itself from a limit, as soon as the master is where the
// slave can be; from what is broken only when asked.
//
//   FollowerAgent follower(context, {.offset_mm = {0, 0, 50}, .mirrored = true});
//   Job job = executor.spawn(follower.run());
//
// Failures of (follow): `absent`, where the master or the slave is not there, or the master's place is not known.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>

#include "agents/runtime/roles.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::follower {

struct FollowerOptions {
  Eigen::Vector3d offset_mm{0, 0, 0};  // in the slave's base frame, after the mirror
  bool mirrored = false;               // y the other way round
};

class FollowerAgent : public runtime::Agent {
 public:
  FollowerAgent(runtime::AgentContext context, FollowerOptions options);
  Task<Result<void>> run() override;

 private:
  enum class State : std::uint8_t { resting, following, limited, broken };
  using See = void (FollowerAgent::*)(const Change&);

  Task<void> watch(Datum pattern, See see);
  Task<void> take(See see, Change change);
  Task<void> watch_roles();
  void see_role(const std::string& role, const std::string& taken);
  void see_pose(const Change& change);
  void see_presence(const Change& change);
  void see_arm(const Change& change);

  Task<Result<Datum>> handle(Datum operation);
  Task<Result<Datum>> follow();
  Task<Result<Datum>> rest();
  Task<void> go_after();
  Task<std::optional<Failure>> leg(Eigen::Vector3d to_mm);
  void give_up(Failure why);
  Task<void> stop_slave();
  Task<Result<void>> enter(State state, std::optional<Failure> why, bool commands);
  Eigen::Vector3d wanted_mm() const;
  bool at_work() const { return state_ == State::following || state_ == State::limited; }

  runtime::AgentContext context_;
  const FollowerOptions options_;
  State state_ = State::resting;
  std::string master_, slave_;                 // those of when it was asked last
  std::string told_slave_;                     // of the fact `following`
  std::map<std::string, Eigen::Vector3d> mm_;  // where each arm is that says so
  std::set<std::string> there_;                // the agents
  bool commands_ = false;                      // the slave, as far as the board was told
  std::optional<Failure> given_up_;
  WaitList changed_;
  std::vector<Job> watching_;
  Job stopping_;
  runtime::Service service_;
  runtime::Caller caller_;
  runtime::Roles roles_;
  Job watching_roles_;
  Job going_;
};

}  // namespace pizarra::follower
