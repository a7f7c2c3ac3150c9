#pragma once

// The actions that every test of an arm's driver makes with it, in virtual time. The bench that has the arm and its
// controller is the class itself, with members `executor` and `arm`:
//
//   struct HsesBench : DrivenArm<HsesBench> { VirtualExecutor executor; ... MotomanArm arm{...}; };
//   bench.connect();      // "" or the symbol of what went wrong

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_driver.hpp"
#include "tests/run_task.hpp"

namespace pizarra::arm {

template <class Bench>
class DrivenArm {
 public:
  template <class T>
  T ask(Task<T> task) {
    return run(bench().executor, std::move(task));
  }
  // Empty where nothing went wrong, here and below.
  std::string outcome(Task<Result<void>> task) {
    const Result<void> done = ask(std::move(task));
    return done ? "" : done.error().symbol;
  }
  std::string connect() {
    const Result<std::string> type = ask(bench().arm.identify());
    return type ? outcome(bench().arm.take_control()) : type.error().symbol;
  }
  std::string move(std::vector<Joints> waypoints, double speed = 1) {
    return outcome(bench().arm.start_move(std::move(waypoints), speed));
  }
  Result<ArmReading> read() { return ask(bench().arm.read()); }
  // Polls as the agent does until the move has ended.
  Result<ArmReading> wait() {
    return wait_while([](const ArmReading& reading) { return reading.moving; });
  }
  Result<ArmReading> wait_for_gripper() {
    return wait_while([](const ArmReading& reading) { return reading.gripper_moving; });
  }
  // Where the arm is, but for one axis.
  Joints moved(std::size_t axis, double by) {
    Joints joints = read()->joints;
    joints[axis] += by;
    return joints;
  }

 private:
  Bench& bench() { return static_cast<Bench&>(*this); }
  template <class Goes>
  Result<ArmReading> wait_while(Goes&& goes) {
    Result<ArmReading> reading = read();
    while (reading && goes(*reading)) {
      bench().executor.run_for(20ms);
      reading = read();
    }
    return reading;
  }
};

}  // namespace pizarra::arm
