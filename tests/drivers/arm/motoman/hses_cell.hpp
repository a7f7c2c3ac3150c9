#pragma once

// A Motoman arm driven over an emulated controller in virtual time, by a line that may be bad.

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "tests/drivers/wire/lossy_line.hpp"
#include "tests/run_task.hpp"

namespace pizarra {

inline const ArmModel& up6() {
  static const ArmModel model = shipped_arm("motoman-up6").value();
  return model;
}

struct HsesCell {
  explicit HsesCell(std::uint64_t seed = 1) : seed_(seed) {}

  template <class T>
  T ask(Task<T> task) {
    return run(executor, std::move(task));
  }
  // Takes control and says what went wrong; empty: nothing did.
  std::string connect() {
    const Result<std::string> type = ask(arm.identify());
    if (!type) return type.error().symbol;
    return outcome(arm.take_control());
  }
  std::string outcome(Task<Result<void>> task) {
    const Result<void> done = ask(std::move(task));
    return done ? "" : done.error().symbol;
  }
  std::string move(std::vector<Joints> waypoints, double speed = 1) {
    return outcome(arm.start_move(std::move(waypoints), speed));
  }
  Result<ArmReading> read() { return ask(arm.read()); }
  // Polls as the agent does until the move has ended.
  Result<ArmReading> wait() {
    Result<ArmReading> reading = read();
    while (reading && reading->moving) {
      executor.run_for(20ms);
      reading = read();
    }
    return reading;
  }

 private:
  std::uint64_t seed_;

 public:
  VirtualExecutor executor;
  MovingArm body{executor, up6()};
  ArmCabinet cabinet{executor, body, up6()};
  HsesEmulator emulator{cabinet};
  LossyLine line{executor, Random(seed_), [this](std::string said) { return emulator.answer(std::move(said)); }};
  HsesLink link{executor, line};
  MotomanArm arm{executor, link, up6()};
};

}  // namespace pizarra
