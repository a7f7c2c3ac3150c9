// From the fact `(stop WHO REASON)`, told by a client, to the brake of the arm's controller: board, robot agent and
// client are a process each, the arm is in motion, and another client tells facts all the while.

#include <fmt/format.h>

#include "agents/robot/robot_agent.hpp"
#include "agents/runtime/contract.hpp"
#include "blackboard/query.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/world.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/arms/rows.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr Duration load_pause = 2ms;
constexpr Duration moving_time = 20ms;

Datum form(const std::string& text) { return read_one(text).value(); }
Query query(const std::string& text) { return query_from_datum(form(text)).value(); }

// The simulated arm, which says when its controller has braked.
class HeardArm : public ArmDriver {
 public:
  HeardArm(Link& link, Pipe& listener) : arm_(link), listener_(listener) {}
  Task<Result<std::string>> identify() override { return arm_.identify(); }
  Task<Result<void>> take_control() override { return arm_.take_control(); }
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override {
    braked_ = false;
    return arm_.start_move(std::move(waypoints), speed);
  }
  Task<Result<void>> stop() override {
    const Result<void> stopped = co_await arm_.stop();
    if (!braked_) listener_.say(now_us());
    braked_ = true;
    co_return stopped;
  }
  Task<Result<void>> start_gripper(double opening_mm) override { return arm_.start_gripper(opening_mm); }
  Task<Result<ArmReading>> read() override { return arm_.read(); }

 private:
  SimulatedArm arm_;
  Pipe& listener_;
  bool braked_ = true;
};

void be_the_robot(Pipe& parent, const std::string& address) {
  RealExecutor executor;
  const WorldConfig config;
  World world(executor, config);
  LocalLink link(world);
  HeardArm arm(link, parent);
  const auto board = RemoteBoard::connect(executor, address, "robot").value();
  RobotAgent robot({"robot", "localhost", executor, *board, Random(1)}, arm, config.arm);
  const Job job = executor.spawn([](RobotAgent& agent) -> Task<void> {
    const Result<void> ended = co_await agent.run();
    throw std::runtime_error(describe(ended.error()));
  }(robot));
  executor.run_until([] { return false; });
}

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

Task<Result<Answer>> await_fact(Client& client, std::string pattern, Duration longest) {
  const Time deadline = client.executor().now() + longest;
  return await_answer(client.board(), query(pattern), deadline, client.executor());
}

Task<void> rest(Executor& executor) { co_await sleep(executor, moving_time); }

// Begins a motion, lets it run a while, and tells the stop; answers when it was told.
double stop_once(Client& client, std::uint64_t count) {
  const char* side = count % 2 == 0 ? "right" : "left";
  client.run(client.board().tell(form(fmt::format("(request s{} robot (turn {} 120))", count, side))));
  client.run(await_fact(client, "(arm robot moving ?action)", 5s));
  client.run(rest(client.executor()));
  const double told_us = now_us();
  client.run(client.board().tell(form("(stop bench \"a try\")")));
  return told_us;
}

void go_on(Client& client, std::uint64_t count) {
  client.run(await_fact(client, fmt::format("(reply s{} ?answer)", count), 5s));
  client.run(client.board().retract(form("(stop bench ?)")));
}

}  // namespace

void stop_latency(ArmsBench& bench) {
  const BoardProcess board;
  Child robot = Child::running([&](Pipe& parent) { be_the_robot(parent, board.address()); });
  Child load = Child::running([&](Pipe& parent) { be_the_load(parent, board.address()); });
  load.pipe().hear();
  Client client(board.address(), "bench");
  client.run(client.board().declare(runtime_relations()));
  client.run(await_fact(client, "(agent robot ?kind ?host)", 10s));
  client.run(await_fact(client, "(arm robot idle ?action)", 10s));
  std::vector<double> ms;
  for (std::uint64_t count = 0; count < bench.stops; ++count) {
    const double told_us = stop_once(client, count);
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
