#pragma once

// The arm that an emulated controller moves: one of its own, or the simulated world's.
//
//   Body body(executor, model, "ipc:///run/user/1000/pizarra/blocks@localhost/world.ipc");   // or "": its own
//   ArmCabinet cabinet(executor, body.arm(), model);

#include <optional>
#include <zmq.hpp>

#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/socket_link.hpp"

namespace pizarra::programs {

class Body {
 public:
  Body(Executor& executor, const arm::ArmModel& model, const std::string& world) : own_(executor, model) {
    if (world.empty()) return;
    link_.emplace(executor, context_, world);
    worlds_.emplace(*link_);
  }
  arm::ArmDriver& arm() { return worlds_ ? static_cast<arm::ArmDriver&>(*worlds_) : own_; }

 private:
  simulation::MovingArm own_;
  zmq::context_t context_{1};
  std::optional<simulation::SocketLink> link_;
  std::optional<simulation::SimulatedArm> worlds_;
};

}  // namespace pizarra::programs
