// From the fact `(request ...)` of a motion, told by a client, to the first octet of its move on the wire to the arm's
// controller, beyond what the board takes to answer a tell. Board, robot agent (with the emulated controller at the
// other end of a UDP line of this machine) and client are a process each.

#include <fmt/format.h>

#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/wire/udp_wire.hpp"
#include "tests/bench/arms/robot_process.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

// A UDP line that says when a move goes over it.
class HeardWire : public DatagramWire {
 public:
  HeardWire(Executor& executor, std::uint16_t port, Pipe& listener)
      : wire_(executor, "127.0.0.1", port), listener_(listener) {}
  Task<Result<void>> open(Time deadline) override { return wire_.open(deadline); }
  void close() override { wire_.close(); }
  Result<void> send(std::string_view datagram) override {
    const Result<HsesRequest> request = read_hses_request(datagram);
    const bool moves = request && (request->command == hses::move_pulses || request->command == hses::move_cartesian);
    if (moves) listener_.say(now_us());
    return wire_.send(datagram);
  }
  Task<Result<std::string>> receive(Time deadline) override { return wire_.receive(deadline); }

 private:
  UdpWire wire_;
  Pipe& listener_;
};

void be_the_robot(Pipe& parent, const std::string& address) {
  RealExecutor executor;
  const ArmModel model = shipped_arm("motoman-up6").value();
  MovingArm body(executor, model);
  ArmCabinet cabinet(executor, body, model);
  HsesEmulator emulator(cabinet);
  const auto port = UdpPort::listen(executor, "127.0.0.1", 0).value();
  const Job serving = executor.spawn(serve(executor, emulator, *port));
  HeardWire wire(executor, port->port(), parent);
  HsesLink link(executor, wire);
  MotomanArm arm(executor, link, model);
  be_a_robot(executor, address, {}, arm, model);
}

double told_in_us(Client& client, Datum fact) {
  const double before_us = now_us();
  client.run(client.board().tell(std::move(fact)));
  return now_us() - before_us;
}

}  // namespace

void command_latency(ArmsBench& bench) {
  const BoardProcess board;
  Child robot = Child::running([&](Pipe& parent) { be_the_robot(parent, board.address()); });
  Client client(board.address(), "bench");
  const std::vector<Relation> relations = {object_relation()};
  client.run(client.board().declare(relations));
  wait_for_robots(client, {"robot"});
  std::vector<double> ms;
  std::vector<double> board_ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    board_ms.push_back(told_in_us(client, object_fact(1, static_cast<int>(count))) / 1000);
    const char* side = count % 2 == 0 ? "right" : "left";
    const Datum request = form(fmt::format("(request c{} robot (turn {} 1))", count, side));
    const double told_us = now_us();
    client.run(client.board().tell(request));
    ms.push_back((robot.pipe().hear() - told_us) / 1000);
    client.run(await_fact(client, fmt::format("(reply c{} ?answer)", count), 10s));
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

}  // namespace pizarra::bench
