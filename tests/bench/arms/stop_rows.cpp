// From the fact `(stop WHO REASON)`, told by a client, to the brake of the arm's controller: board, robot agent and
// client are a process each, the arm is in motion, and another client tells facts all the while.

#include <fmt/format.h>

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

}  // namespace

void stop_latency(ArmsBench& bench) {
  const BoardProcess board;
  Child robot = Child::running([&](Pipe& parent) { be_a_simulated_robot(parent, board.address(), {}); });
  Child load = Child::running([&](Pipe& parent) { be_the_load(parent, board.address()); });
  load.pipe().hear();
  Client client(board.address(), "bench");
  wait_for_robots(client, {"robot"});
  std::vector<double> ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    const double told_us = stop_once(client, "robot", count);
    ms.push_back((robot.pipe().hear() - told_us) / 1000);
    go_on(client, count);
  }
  bench.figures.say({"stop fact to the controller's brake, p99",
                     percentile(ms, 0.99),
                     "ms",
                     at_most(20),
                     {},
                     fmt::format("{} tries in motion under load; p50 {:.2f} ms, worst {:.1f} ms", ms.size(),
                                 percentile(ms, 0.5), percentile(ms, 1))});
}

}  // namespace pizarra::bench
