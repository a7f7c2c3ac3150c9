// Moves over a network that loses a fifth of all datagrams and repeats a tenth: how many were carried out exactly once.
// Emulated controller and driver in virtual time. Every other move is a straight one, in Cartesian orders. Copies come
// at most 10 ms late: one that is older than the move in hand is beyond what the protocol lets a driver promise
// (motoman_arm.hpp).

#include <fmt/format.h>

#include "agents/robot/motion.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "tests/bench/arms/robot_process.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/drivers/line/lossy_line.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {

namespace {

constexpr double loss = 0.2;
constexpr double duplication = 0.1;
constexpr double nearly = 0.02;  // degrees: a Cartesian order is in micrometres and in 0.0001 degrees

// A move, and in how many orders the driver has it carried out.
struct WireMove {
  std::vector<arm::Joints> waypoints;
  std::uint64_t orders = 1;
};

WireMove anywhere_near(const arm::ArmModel& model, Random& random) {
  arm::Joints there = model.ready;
  for (double& axis : there) axis += random.uniform(-5, 5);
  return {{there}};
}

WireMove straight_from(const arm::ArmModel& model, const arm::Joints& from, Random& random) {
  const char* side = random.below(2) == 0 ? "right" : "left";
  const Datum operation = form(fmt::format("(move-h {} {})", side, 10 + random.below(30)));
  std::vector<arm::Joints> waypoints = robot::plan_motion(model, operation, from, {}).value().waypoints;
  const std::vector<arm::Leg> legs = arm::legs_of(model, from, waypoints);
  return {std::move(waypoints), legs.size()};
}

// Whether the arm ended where it was sent, without having been sent anywhere else.
bool go(Executor& executor, arm::MotomanArm& arm, const simulation::ArmCabinet& cabinet, const WireMove& move) {
  const std::uint64_t before = cabinet.moves();
  std::vector<arm::Joints> waypoints = move.waypoints;
  const Result<void> started = run(executor, arm.start_move(std::move(waypoints), 1));
  if (!started) return false;
  Result<arm::ArmReading> reading = run(executor, arm.read());
  while (reading && reading->moving) {
    const Time until = executor.now() + 20ms;
    executor.call_at(until, [] {});
    executor.run_until([&] { return executor.now() >= until; });
    reading = run(executor, arm.read());
  }
  const arm::Joints& there = move.waypoints.back();
  return reading && !reading->stopped && arm::are_same_place(reading->joints, there, nearly) &&
         cabinet.moves() == before + move.orders && arm::are_same_place(cabinet.last_target(), there, nearly);
}

}  // namespace

void bad_network(ArmsBench& bench) {
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  VirtualExecutor executor;
  simulation::MovingArm body(executor, model);
  simulation::ArmCabinet cabinet(executor, body, model);
  simulation::HsesEmulator emulator(cabinet);
  line::LossyLine line(executor, Random(1), [&](std::string said) { return emulator.answer(std::move(said)); });
  line.loss = loss;
  line.duplication = duplication;
  line.longest_delay = 10ms;
  arm::HsesLink link(executor, line);
  arm::MotomanArm arm(executor, link, model);
  if (!run(executor, arm.identify()) || !run(executor, arm.take_control())) throw std::runtime_error("no control");
  Random random(2);
  std::uint64_t once = 0;
  std::uint64_t straight_orders = 0;
  for (std::uint64_t i = 0; i < bench.moves; ++i) {
    const arm::Joints at = run(executor, arm.read()).value().joints;
    const WireMove move = i % 2 == 0 ? anywhere_near(model, random) : straight_from(model, at, random);
    straight_orders += i % 2 == 0 ? 0 : move.orders;
    once += go(executor, arm, cabinet, move) ? 1 : 0;
  }
  const auto all = static_cast<double>(bench.moves);
  bench.figures.say({"motoman-up6 over HSES, 20 % lost, 10 % twice: moves carried out exactly once",
                     static_cast<double>(once),
                     "moves",
                     at_least(all, fmt::format("all {}", bench.moves)),
                     {},
                     fmt::format("{} straight ones in {} orders; {} datagrams, {} lost, {} repeated, none later than "
                                 "10 ms: the protocol knows no older copy",
                                 bench.moves / 2, straight_orders, line.sent, line.lost, line.repeated)});
}

}  // namespace pizarra::bench
