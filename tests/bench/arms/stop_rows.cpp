// From the fact `(stop WHO REASON)`, told by a client, to the arm's brake: board, robot agent and client are a process
// each, the arm is in motion, and another client tells facts all the while. Once with the simulated arm, which is in
// the agent's process and has no controller; once with an emulated controller in a process of its own, over its wire.

#include <fmt/format.h>

#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/line/udp_wire.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "tests/bench/arms/robot_process.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr Duration load_pause = 2ms;

Task<void> tell_all_the_while(Client& client) {
  for (int i = 0;; ++i) {
    Datum fact = object_fact(i % 100, i);
    [[maybe_unused]] const Result<Revision> told = co_await client.board().tell(fact);
    co_await sleep(client.executor(), load_pause);
  }
}

void be_the_load(Pipe& parent, const std::string& address) {
  Client client(address, "load");
  const std::vector<Relation> relations = {object_relation()};
  client.run(client.board().declare(relations));
  parent.say(0);
  client.run(tell_all_the_while(client));
}

// What an emulated controller moves; says when it begins to move, and when it begins to brake.
class HeardBody : public arm::ArmDriver {
 public:
  HeardBody(Executor& executor, const arm::ArmModel& model, Pipe& listener)
      : body_(executor, model), listener_(listener) {}
  Task<Result<std::string>> identify() override { return body_.identify(); }
  Task<Result<void>> take_control() override { return body_.take_control(); }
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override {
    const Result<void> started = co_await body_.start_move(std::move(waypoints), speed);
    runs_ = started.has_value();
    if (runs_) listener_.say(now_us());
    co_return started;
  }
  Task<Result<void>> stop() override {
    const Result<arm::ArmReading> before = co_await body_.read();
    const bool brakes = runs_ && before && before->moving;
    const Result<void> stopped = co_await body_.stop();
    if (brakes) listener_.say(now_us());
    runs_ = false;
    co_return stopped;
  }
  Task<Result<void>> start_gripper(double opening_mm) override { return body_.start_gripper(opening_mm); }
  Task<Result<arm::ArmReading>> read() override { return body_.read(); }
  std::uint64_t states_heard() const override { return body_.states_heard(); }

 private:
  simulation::MovingArm body_;
  Pipe& listener_;
  bool runs_ = false;
};

// The controller of an UP6 at a free port, which it says first.
void be_the_controller(Pipe& parent) {
  RealExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  HeardBody body(executor, model, parent);
  simulation::ArmCabinet cabinet(executor, body, model);
  simulation::HsesEmulator emulator(cabinet);
  const auto port = line::UdpPort::listen(executor, "127.0.0.1", 0).value();
  const Job serving = executor.spawn(simulation::serve(executor, emulator, *port));
  parent.say(port->port());
  executor.run_until([] { return false; });
}

void be_a_wired_robot(const std::string& address, std::uint16_t port) {
  RealExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  line::UdpWire wire(executor, "127.0.0.1", port);
  arm::HsesLink link(executor, wire);
  arm::MotomanArm arm(executor, link, model);
  be_a_robot(executor, address, {}, arm, model);
}

void say_latency(ArmsBench& bench, const std::string& what, const std::vector<double>& ms) {
  bench.figures.say({what,
                     percentile(ms, 0.99),
                     "ms",
                     at_most(20),
                     {},
                     fmt::format("{} tries in motion under load; p50 {:.2f} ms, worst {:.1f} ms", ms.size(),
                                 percentile(ms, 0.5), percentile(ms, 1))});
}

void simulated_arm(ArmsBench& bench) {
  const BoardProcess board;
  Child robot = Child::running([&](Pipe& parent) { be_a_simulated_robot(parent, board.address(), {}); });
  Child load = Child::running([&](Pipe& parent) { be_the_load(parent, board.address()); });
  load.pipe().hear();
  Client client(board.address(), "bench");
  wait_for_robots(client, {"robot"});
  std::vector<double> ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    begin_turn(client, "robot", count);
    const double told_us = stop_turn(client);
    ms.push_back((robot.pipe().hear() - told_us) / 1000);
    go_on(client, count);
  }
  say_latency(bench, "stop fact to the simulated arm's brake, in the agent's process, p99", ms);
}

void emulated_controller(ArmsBench& bench) {
  const BoardProcess board;
  Child controller = Child::running(be_the_controller);
  const auto port = static_cast<std::uint16_t>(controller.pipe().hear());
  const Child robot = Child::running([&](Pipe&) { be_a_wired_robot(board.address(), port); });
  Child load = Child::running([&](Pipe& parent) { be_the_load(parent, board.address()); });
  load.pipe().hear();
  Client client(board.address(), "bench");
  wait_for_robots(client, {"robot"});
  std::vector<double> ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    begin_turn(client, "robot", count);
    controller.pipe().hear();
    const double told_us = stop_turn(client);
    ms.push_back((controller.pipe().hear() - told_us) / 1000);
    go_on(client, count);
  }
  say_latency(bench, "stop fact to an emulated UP6 decelerating, HSES over UDP to its process, p99", ms);
}

}  // namespace

void stop_latency(ArmsBench& bench) {
  simulated_arm(bench);
  emulated_controller(bench);
}

}  // namespace pizarra::bench
