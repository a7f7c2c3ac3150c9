#pragma once

// The parts of one robot agent, each of which stands on those before it. The agent wires them once; its operations
// (moving_operations.hpp, resting_operations.hpp) work on them.

#include "agents/robot/arm_control.hpp"
#include "agents/robot/holds.hpp"
#include "agents/robot/reflex.hpp"
#include "agents/robot/rest_watch.hpp"
#include "agents/robot/robot_agent.hpp"
#include "agents/robot/robot_memory.hpp"
#include "agents/runtime/service.hpp"

namespace pizarra::robot {

struct RobotParts {
  // The service may be constructed later: until it runs it is only referred to.
  RobotParts(runtime::AgentContext given, arm::ArmDriver& driver, arm::ArmModel described, const RobotOptions& options,
             const runtime::Service& its_service)
      : context(std::move(given)),
        model(std::move(described)),
        room(options.room),
        service(its_service),
        facts(context, its_service),
        connection(context.executor, driver, model, facts),
        control(context.executor, connection, room, period_of(options.told_per_s), facts),
        rest(context.executor, connection, control, facts, period_of(options.told_per_s)),
        reflex(context, control),
        holds(context, control),
        memory(context, model) {}

  runtime::AgentContext context;
  const arm::ArmModel model;
  const std::optional<WorkVolume> room;
  const runtime::Service& service;
  ArmFacts facts;
  ArmConnection connection;
  ArmControl control;
  RestWatch rest;
  Reflex reflex;
  Holds holds;
  RobotMemory memory;

 private:
  static Duration period_of(double per_s) {
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / per_s));
  }
};

// The answer of an operation that says only whether it was done.
inline Datum done_answer(bool done) { return list(done ? "true"_sym : "false"_sym); }

}  // namespace pizarra::robot
