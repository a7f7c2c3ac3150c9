#pragma once

// An arm that moves and of which no state comes any more moves unseen: nobody holds it to its limits, speeds and room.
// For as long as this lives it counts beats of its own, whatever the driver's calls wait for, and says when the
// driver's longest silence is over; again where it goes on.
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
