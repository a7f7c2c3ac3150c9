#pragma once

// Notices when an arm moves and its controller tells no state: then nothing checks its limits, speeds and room. While
// this lives it counts by a timer of its own, whatever the driver's calls wait for. It calls back when the driver's
// longest silence is over, and again as long as the silence lasts.
//
//   const Silence silence(executor, driver, [this](Failure why) { stop_at_once(std::move(why)); });

#include <functional>

#include "blackboard/time/executor.hpp"
#include "drivers/arm/arm_driver.hpp"

namespace pizarra::robot {

class Silence {
 public:
  static constexpr int beats = 10;  // of a silence

  // The driver outlives it.
  Silence(Executor& executor, const arm::ArmDriver& driver, std::function<void(Failure)> tell)
      : executor_(executor), driver_(driver), tell_(std::move(tell)), listening_(executor.spawn(listen())) {}
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  Task<void> listen();

  Executor& executor_;
  const arm::ArmDriver& driver_;
  std::function<void(Failure)> tell_;
  Job listening_;
};

}  // namespace pizarra::robot
