// The state of an arm in motion told as facts 125 times a second: how many poses a client of the board is told, how far
// apart they come, and whether a stop is any later for it. Board, robot agents and client are a process each.

#include <fmt/format.h>

#include "blackboard/query.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/line/tcp_port.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"
#include "tests/bench/arms/robot_process.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr double wanted_hz = 125;
constexpr double nearly = 0.99;  // of it: motions begin and end between two beats
constexpr Duration watched = 8s;

std::unique_ptr<line::TcpPort> free_port(Executor& executor) {
  return line::TcpPort::listen(executor, "127.0.0.1", 0).value();
}

// An UR5e on an emulated controller in the same process, over TCP.
void be_a_universal_robot(const std::string& address) {
  RealExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("ur5e").value();
  simulation::MovingArm body(executor, model);
  simulation::ArmCabinet cabinet(executor, body, model);
  simulation::UrEmulator emulator(cabinet);
  const auto rtde = free_port(executor), script = free_port(executor), dashboard = free_port(executor);
  const Job telling = executor.spawn(simulation::serve_rtde(executor, emulator, *rtde));
  const Job running =
      executor.spawn(simulation::serve_interface(executor, emulator, simulation::UrInterface::secondary, *script));
  const Job answering = executor.spawn(simulation::serve_dashboard(executor, emulator, *dashboard));
  line::TcpWire to_rtde(executor, "127.0.0.1", rtde->port());
  line::TcpWire to_script(executor, "127.0.0.1", script->port());
  line::TcpWire to_dashboard(executor, "127.0.0.1", dashboard->port());
  arm::UniversalArm arm(executor, {to_rtde, to_script, to_dashboard}, model);
  be_a_robot(executor, address, {.name = "robot", .told_per_s = wanted_hz}, arm, model);
}

// Notes when each pose comes.
Task<void> note_poses(Client& client, std::vector<double>& ms, std::optional<Failure>& failure) {
  const Query poses = query_from_datum(form("(arm-pose robot ?x ?y ?z ?rx ?ry ?rz)")).value();
  const Result<std::unique_ptr<Watch>> watch = co_await client.board().watch(poses);
  if (!watch) failure = watch.error();
  while (!failure) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) failure = change.error();
    if (change && !change->resynchronised && !change->added.empty()) ms.push_back(now_us() / 1000);
  }
}

// When each came, in milliseconds.
std::vector<double> poses_within(Client& client, Duration length) {
  std::vector<double> ms;
  std::optional<Failure> failure;
  const Job job = client.executor().spawn(note_poses(client, ms, failure));
  bool over = false;
  client.executor().call_at(client.executor().now() + length, [&over] { over = true; });
  client.executor().run_until([&] { return over || failure; });
  if (failure) throw std::runtime_error(describe(*failure));
  if (ms.size() < 2)
    throw std::runtime_error(fmt::format("the arm in motion told {} poses in {} s", ms.size(), length / 1s));
  return ms;
}

void tell_rate(ArmsBench& bench, const std::string& what, const std::string& address) {
  Client client(address, "bench");
  wait_for_robots(client, {"robot"});
  client.run(client.board().tell(form("(request slow robot (speed 3))")));
  client.run(await_fact(client, "(reply slow ?answer)", 5s));
  client.run(client.board().tell(form("(request turn robot (turn right 120))")));
  client.run(await_fact(client, "(arm robot moving ?action)", 5s));
  const std::vector<double> ms = poses_within(client, watched);
  std::vector<double> gaps_ms;
  for (std::size_t i = 1; i < ms.size(); ++i) gaps_ms.push_back(ms[i] - ms[i - 1]);
  const double hz = static_cast<double>(ms.size()) / std::chrono::duration<double>(watched).count();
  bench.figures.say({what + " in motion: poses told",
                     hz,
                     "Hz",
                     at_least(nearly * wanted_hz, "125"),
                     {},
                     fmt::format("{} poses; gaps p50 {:.1f} ms, p99 {:.1f}, worst {:.1f}", ms.size(),
                                 percentile(gaps_ms, 0.5), percentile(gaps_ms, 0.99), percentile(gaps_ms, 1))});
}

// Two arms stopped in turns, one of which tells its state as often as it should, the other as it does by itself.
void tell_delay(ArmsBench& bench) {
  const BoardProcess board;
  const std::string& address = board.address();
  Child often = Child::running([&](Pipe& parent) { be_a_simulated_robot(parent, address, {"often", wanted_hz}); });
  Child seldom = Child::running([&](Pipe& parent) { be_a_simulated_robot(parent, address, {"seldom"}); });
  Client client(address, "bench");
  wait_for_robots(client, {"often", "seldom"});
  std::vector<double> often_ms;
  std::vector<double> seldom_ms;
  const std::uint64_t tries = std::max<std::uint64_t>(bench.stops / 2, 10);
  for (std::uint64_t count = 0; count < 2 * tries; ++count) {
    const bool first = count % 2 == 0;
    Pipe& pipe = (first ? often : seldom).pipe();
    begin_turn(client, first ? "often" : "seldom", count);
    const double told_us = stop_turn(client);
    (first ? often_ms : seldom_ms).push_back((pipe.hear() - told_us) / 1000);
    go_on(client, count);
  }
  bench.figures.say(
      {"stop fact to the simulated arm's brake, in the agent's process, at 125 Hz, p99",
       percentile(often_ms, 0.99),
       "ms",
       at_most(20),
       {},
       fmt::format("{} stops each in turns; at 125 Hz p50 {:.2f} ms, p90 {:.2f}; at 10 Hz p50 {:.2f}, p90 "
                   "{:.2f}, p99 {:.2f}",
                   tries, percentile(often_ms, 0.5), percentile(often_ms, 0.9), percentile(seldom_ms, 0.5),
                   percentile(seldom_ms, 0.9), percentile(seldom_ms, 0.99))});
}

}  // namespace

void state_stream(ArmsBench& bench) {
  {
    const BoardProcess board;
    const RobotName robot{.name = "robot", .told_per_s = wanted_hz};
    const Child child = Child::running([&](Pipe& parent) { be_a_simulated_robot(parent, board.address(), robot); });
    tell_rate(bench, "simulated crs-f3", board.address());
  }
  {
    const BoardProcess board;
    const Child child = Child::running([&](Pipe&) { be_a_universal_robot(board.address()); });
    tell_rate(bench, "ur5e over RTDE", board.address());
  }
  tell_delay(bench);
}

}  // namespace pizarra::bench
