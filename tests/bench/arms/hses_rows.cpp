// Moves over a network that loses a fifth of all datagrams and repeats a tenth: how many were carried out exactly once.
// Emulated controller and driver in virtual time.

#include <fmt/format.h>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/drivers/wire/lossy_line.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {

namespace {

constexpr double loss = 0.2;
constexpr double duplication = 0.1;

// Whether the arm ended where it was sent, without having been sent anywhere else.
bool go(Executor& executor, MotomanArm& arm, const ArmCabinet& cabinet, const Joints& there) {
  const std::uint64_t before = cabinet.moves();
  std::vector<Joints> waypoints{there};
  const Result<void> started = run(executor, arm.start_move(std::move(waypoints), 1));
  if (!started) return false;
  Result<ArmReading> reading = run(executor, arm.read());
  while (reading && reading->moving) {
    const Time until = executor.now() + 20ms;
    executor.call_at(until, [] {});
    executor.run_until([&] { return executor.now() >= until; });
    reading = run(executor, arm.read());
  }
  return reading && !reading->stopped && are_same_place(reading->joints, there) && cabinet.moves() == before + 1 &&
         are_same_place(cabinet.last_target(), there);
}

}  // namespace

void bad_network(ArmsBench& bench) {
  const ArmModel model = shipped_arm("motoman-up6").value();
  VirtualExecutor executor;
  MovingArm body(executor, model);
  ArmCabinet cabinet(executor, body, model);
  HsesEmulator emulator(cabinet);
  LossyLine line(executor, Random(1), [&](std::string said) { return emulator.answer(std::move(said)); });
  line.loss = loss;
  line.duplication = duplication;
  line.longest_delay = 10ms;
  HsesLink link(executor, line);
  MotomanArm arm(executor, link, model);
  if (!run(executor, arm.identify()) || !run(executor, arm.take_control())) throw std::runtime_error("no control");
  Random random(2);
  std::uint64_t once = 0;
  for (std::uint64_t i = 0; i < bench.moves; ++i) {
    Joints there = model.ready;
    for (double& axis : there) axis += random.uniform(-5, 5);
    once += go(executor, arm, cabinet, there) ? 1 : 0;
  }
  const auto all = static_cast<double>(bench.moves);
  bench.figures.say({"motoman-up6 over HSES, 20 % lost, 10 % twice: moves carried out exactly once",
                     static_cast<double>(once),
                     "moves",
                     at_least(all, fmt::format("all {}", bench.moves)),
                     {},
                     fmt::format("{} datagrams, {} lost, {} repeated", line.sent, line.lost, line.repeated)});
}

}  // namespace pizarra::bench
