#pragma once

// The robot agent: the thesis' seventeen operations, `move-to`, `get-control`, `release-control` and held jogs
// (holds.hpp), over any ArmDriver, the same for every arm.
//
// Lifecycle: constructed, run() spawned. It asks the controller which arm it is of (one that says another than
// the cell describes ends run() with `unknown-arm`; most protocols say less, see the drivers) and stops what moves
// there, before it waits for its name; then takes control, reads back its learned variables and its speed from durable
// facts, and serves. A controller that goes away is connected to again when it is back, as it is then: meanwhile motion
// answers `disconnected` and the arm's fact says `fault`, and what it has for an alarm stays until somebody asks for
// (get-control). Control that somebody released stays so until then, in every later life of this agent.
//
// One motion at a time, the gripper's included (`busy`, with the running operation as the subject); get-status,
// monitor, finish, speed and learn are answered meanwhile. Every motion has one plan, made before it starts, so that a
// refused motion has moved nothing. Every motion is done once: the durable fact `(robot-motion ROBOT REQUEST OUTCOME)`
// says which motion was begun last and how it ended. So the successor of an agent that died in mid-motion answers that
// request, `stopped` or as it ended, and does not move for it.
//
//   RobotAgent robot(AgentContext{"robot", "localhost", executor, board, random}, arm, model);
//   Job job = executor.spawn(until_it_ends(robot));

#include <memory>
#include <optional>

#include "agents/robot/work_volume.hpp"
#include "agents/runtime/agent.hpp"
#include "drivers/arm/arm_driver.hpp"

namespace pizarra::robot {

struct RobotOptions {
  std::optional<WorkVolume> room = {};  // where its grip centre stays
  double told_per_s = 10;               // how often pose and joints are told while they change
  std::string context = "arms";         // in which its name is bound: of those that can take its place
};

class RobotAgent : public runtime::Agent {
 public:
  // The driver outlives the agent; the model is that of the arm that its controller will say it is of.
  RobotAgent(runtime::AgentContext context, arm::ArmDriver& driver, arm::ArmModel model, RobotOptions options = {});
  ~RobotAgent() override;
  Task<Result<void>> run() override;
  // For a process that is to end: stops the motion in hand, which then fails with `stopped`, and answers when it has
  // ended. Most controllers would carry it out to its end. At rest it does nothing.
  Task<void> stand_still();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pizarra::robot
