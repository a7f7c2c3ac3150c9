#pragma once

// The durable facts of the robot agent: the learned variables, the speed, who released control, and the newest motion.
// Its successor goes on from there.
//
// Lifecycle: recall() before the first operation; it reads what an earlier life kept.
//
//   const Result<void> recalled = co_await memory.recall();
//   if (const Result<Datum>* known = memory.answer_to(request_id)) ...     // it was begun in an earlier life
//   memory.add_begin(transaction, request_id);                              // before anything moves

#include <optional>
#include <string>

#include "agents/robot/motion.hpp"
#include "agents/runtime/agent.hpp"

namespace pizarra::robot {

class RobotMemory {
 public:
  RobotMemory(runtime::AgentContext& context, const arm::ArmModel& model)
      : context_(context), model_(model), name_(Datum::symbol(context.name)) {}

  // A fact that somebody else mangled is left alone.
  Task<Result<void>> recall();

  const ArmVariables& variables() const { return variables_; }
  double speed_percent() const { return speed_percent_; }
  // Who had released control when recall() read it.
  const std::optional<std::string>& released_by() const { return released_by_; }
  // The answer to the request of an earlier life's newest motion; null for other requests.
  const Result<Datum>* answer_to(const Datum& request) const;

  Task<Result<void>> keep_speed(double percent);
  // Failure out-of-range: too many others are learned.
  Result<void> check_variable(const Datum& variable) const;
  Task<Result<void>> keep_variable(Datum variable, arm::Joints joints);

  // These join a transaction that its caller commits.
  void add_begin(Transaction& transaction, const Datum& request) const;
  void add_end(Transaction& transaction, const Datum& request, const Result<void>& moved) const;
  void add_taken(Transaction& transaction) const;
  void add_released(Transaction& transaction, const std::string& client) const;

 private:
  // The newest motion of an earlier life, and what its request is answered.
  struct EarlierMotion {
    Datum request;
    Result<Datum> answer;
  };

  Task<Result<std::vector<Fact>>> known(Datum pattern);
  Datum released_fact(const Datum& client) const { return list("robot-released"_sym, name_, client); }
  Datum motion_fact(const Datum& request, const Datum& outcome) const {
    return list("robot-motion"_sym, name_, request, outcome);
  }

  runtime::AgentContext& context_;
  const arm::ArmModel& model_;
  const Datum name_;  // the first argument of each
  ArmVariables variables_;
  double speed_percent_ = 100;
  std::optional<std::string> released_by_;
  std::optional<EarlierMotion> earlier_;
};

}  // namespace pizarra::robot
