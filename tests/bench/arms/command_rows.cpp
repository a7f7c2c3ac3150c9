// The time from the fact `(request ...)` of a motion, told by a client, to the first octet of its move on the wire to
// the arm's controller. The board's time to answer a tell is subtracted; and the same beside a stream of 125 states a
// second. Board, robot agent (with the emulated controller at the other end of a UDP line of this machine) and client
// are a process each.

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

// A UDP line that says when a move goes over it.
class HeardWire : public line::DatagramWire {
 public:
  HeardWire(Executor& executor, std::uint16_t port, Pipe& listener)
      : wire_(executor, "127.0.0.1", port), listener_(listener) {}
  Task<Result<void>> open(Time deadline) override { return wire_.open(deadline); }
  void close() override { wire_.close(); }
  Result<void> send(std::string_view datagram) override {
    const Result<arm::HsesRequest> request = arm::read_hses_request(datagram);
    const bool moves =
        request && (request->command == arm::hses::move_pulses || request->command == arm::hses::move_cartesian);
    if (moves) listener_.say(now_us());
    return wire_.send(datagram);
  }
  Task<Result<std::string>> receive(Time deadline) override { return wire_.receive(deadline); }

 private:
  line::UdpWire wire_;
  Pipe& listener_;
};

void be_the_robot(Pipe& parent, const std::string& address, const RobotName& name) {
  RealExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  simulation::MovingArm body(executor, model);
  simulation::ArmCabinet cabinet(executor, body, model);
  simulation::HsesEmulator emulator(cabinet);
  const auto port = line::UdpPort::listen(executor, "127.0.0.1", 0).value();
  const Job serving = executor.spawn(simulation::serve(executor, emulator, *port));
  HeardWire wire(executor, port->port(), parent);
  arm::HsesLink link(executor, wire);
  arm::MotomanArm arm(executor, link, model);
  be_a_robot(executor, address, name, arm, model);
}

// Has the robot `streaming` turn to and fro, slowly, so that it tells its state without an end.
Task<void> turn_to_and_fro(Client& client) {
  Board& board = client.board();
  static_cast<void>(co_await board.tell(form("(request slow streaming (speed 3))")));
  static_cast<void>(co_await await_fact(client, "(reply slow ?answer)", 10s));
  for (int i = 0;; ++i) {
    const char* side = i % 2 == 0 ? "right" : "left";
    Datum request = form(fmt::format("(request t{} streaming (turn {} 90))", i, side));
    static_cast<void>(co_await board.tell(std::move(request)));
    std::string answered = fmt::format("(reply t{} ?answer)", i);
    static_cast<void>(co_await await_fact(client, std::move(answered), 60s));
  }
}

void be_the_mover(Pipe& parent, const std::string& address) {
  Client client(address, "mover");
  wait_for_robots(client, {"streaming"});
  parent.say(0);
  client.run(turn_to_and_fro(client));
}

double told_in_us(Client& client, Datum fact) {
  const double before_us = now_us();
  client.run(client.board().tell(std::move(fact)));
  return now_us() - before_us;
}

// A command to the robot, which stands, and its move on the wire.
double command_once(Client& client, Pipe& robot, std::uint64_t count) {
  const char* side = count % 2 == 0 ? "right" : "left";
  const Datum request = form(fmt::format("(request c{} robot (turn {} 1))", count, side));
  const double told_us = now_us();
  client.run(client.board().tell(request));
  const double ms = (robot.hear() - told_us) / 1000;
  client.run(await_fact(client, fmt::format("(reply c{} ?answer)", count), 10s));
  return ms;
}

void alone(ArmsBench& bench) {
  const BoardProcess board;
  Child robot = Child::running([&](Pipe& parent) { be_the_robot(parent, board.address(), {}); });
  Client client(board.address(), "bench");
  const std::vector<Relation> relations = {object_relation()};
  client.run(client.board().declare(relations));
  wait_for_robots(client, {"robot"});
  std::vector<double> ms;
  std::vector<double> board_ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    board_ms.push_back(told_in_us(client, object_fact(1, static_cast<int>(count))) / 1000);
    ms.push_back(command_once(client, robot.pipe(), count));
  }
  const double round_trip_ms = percentile(board_ms, 0.99);
  bench.figures.say(
      {"command fact to its move on the wire, p99 beyond the board's round trip",
       percentile(ms, 0.99) - round_trip_ms,
       "ms",
       at_most(1),
       {},
       fmt::format("{} commands, p50 {:.2f} ms, p99 {:.2f}; a round trip of the board between them p50 "
                   "{:.2f} ms, p99 {:.2f}",
                   ms.size(), percentile(ms, 0.5), percentile(ms, 0.99), percentile(board_ms, 0.5), round_trip_ms)});
}

// Two boards in turns: on one the robot tells its state 125 times a second, and so does another that moves all the
// while.
void beside_a_stream(ArmsBench& bench) {
  constexpr double often_hz = 125;
  const BoardProcess busy;
  const BoardProcess quiet;
  Child often = Child::running([&](Pipe& parent) { be_the_robot(parent, busy.address(), {"robot", often_hz}); });
  Child seldom = Child::running([&](Pipe& parent) { be_the_robot(parent, quiet.address(), {}); });
  const Child streaming = Child::running([&](Pipe& parent) {
    be_a_simulated_robot(parent, busy.address(), {"streaming", often_hz});
  });
  Client to_busy(busy.address(), "bench");
  Client to_quiet(quiet.address(), "bench");
  wait_for_robots(to_busy, {"robot"});
  wait_for_robots(to_quiet, {"robot"});
  Child mover = Child::running([&](Pipe& parent) { be_the_mover(parent, busy.address()); });
  mover.pipe().hear();
  std::vector<double> busy_ms;
  std::vector<double> quiet_ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    busy_ms.push_back(command_once(to_busy, often.pipe(), count));
    quiet_ms.push_back(command_once(to_quiet, seldom.pipe(), count));
  }
  bench.figures.say({"command fact to its move on the wire: how much later beside a stream of 125 Hz, p99",
                     percentile(busy_ms, 0.99) - percentile(quiet_ms, 0.99),
                     "ms",
                     at_most(1),
                     {},
                     fmt::format("{} commands each in turns; beside the stream p50 {:.2f} ms, p99 {:.2f}; without "
                                 "{:.2f}, {:.2f}",
                                 busy_ms.size(), percentile(busy_ms, 0.5), percentile(busy_ms, 0.99),
                                 percentile(quiet_ms, 0.5), percentile(quiet_ms, 0.99))});
}

}  // namespace

void command_latency(ArmsBench& bench) {
  alone(bench);
  beside_a_stream(bench);
}

}  // namespace pizarra::bench
