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

namespace pizarra {

class Body {
 public:
  Body(Executor& executor, const ArmModel& model, const std::string& world) : own_(executor, model) {
    if (world.empty()) return;
    link_.emplace(executor, context_, world);
    worlds_.emplace(*link_);
  }
  ArmDriver& arm() { return worlds_ ? static_cast<ArmDriver&>(*worlds_) : own_; }

 private:
  MovingArm own_;
  zmq::context_t context_{1};
  std::optional<SocketLink> link_;
  std::optional<SimulatedArm> worlds_;
};

}  // namespace pizarra
