#pragma once

// Plug-ins as devices of the device link (drivers/simulation/link.hpp), which a SimulatedArm or SimulatedCamera in the
// agent's process talks to: what they ask is asked of the plug-in, and what it throws is answered as a failure.
//
//   ArmDevice device(*arm);
//   Result<Message> answer = device.handle(request);      // (arm read), (arm move SPEED (JOINT ...) ...) ...

#include <memory>

#include "blackboard/time/executor.hpp"
#include "drivers/plugin/arm_plugin.hpp"
#include "drivers/plugin/camera_plugin.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::programs {

class PluginDevice {
 public:
  virtual ~PluginDevice() = default;
  // Failures: the plug-in's own, disconnected for what else it throws, bad-request.
  Result<simulation::Message> handle(const Datum& request);

 private:
  virtual Result<simulation::Message> answer(const Datum& request) = 0;
};

std::unique_ptr<PluginDevice> device_of(std::unique_ptr<plugin::Arm> arm);
std::unique_ptr<PluginDevice> device_of(std::unique_ptr<plugin::Camera> camera, Executor& executor);

}  // namespace pizarra::programs
