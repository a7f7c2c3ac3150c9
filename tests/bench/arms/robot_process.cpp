#include "tests/bench/arms/robot_process.hpp"

#include <cstdlib>
#include <fmt/format.h>

#include "agents/runtime/contract.hpp"
#include "blackboard/query.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/world.hpp"
#include "lisp/reader.hpp"

namespace pizarra::bench {

namespace {

constexpr Duration moving_time = 20ms;

// The simulated arm, which says when its controller has braked.
class HeardArm : public arm::ArmDriver {
 public:
  HeardArm(simulation::Link& link, Pipe& listener) : arm_(link), listener_(listener) {}
  Task<Result<std::string>> identify() override { return arm_.identify(); }
  Task<Result<void>> take_control() override { return arm_.take_control(); }
  Task<Result<void>> start_move(std::vector<arm::Joints> waypoints, double speed) override {
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
  Task<Result<arm::ArmReading>> read() override { return arm_.read(); }
  std::uint64_t states_heard() const override { return arm_.states_heard(); }

 private:
  simulation::SimulatedArm arm_;
  Pipe& listener_;
  bool braked_ = true;
};

Task<void> live(robot::RobotAgent& agent) {
  const Result<void> ended = co_await agent.run();
  throw std::runtime_error(describe(ended.error()));
}

Task<void> rest(Executor& executor) { co_await sleep(executor, moving_time); }

}  // namespace

void be_a_robot(RealExecutor& executor, const std::string& address, const RobotName& robot, arm::ArmDriver& arm,
                const arm::ArmModel& model) {
  const auto board = client::RemoteBoard::connect(executor, address, robot.name).value();
  const robot::RobotOptions options{.told_per_s = robot.told_per_s};
  robot::RobotAgent agent({robot.name, "localhost", executor, *board, Random(1)}, arm, model, options);
  const Job job = executor.spawn(live(agent));
  executor.run_until([] { return false; });
  std::abort();
}

void be_a_simulated_robot(Pipe& parent, const std::string& address, const RobotName& robot) {
  RealExecutor executor;
  const simulation::WorldConfig config;
  simulation::World world(executor, config);
  simulation::LocalLink link(world);
  HeardArm arm(link, parent);
  be_a_robot(executor, address, robot, arm, config.arm);
}

Datum form(const std::string& text) { return read_one(text).value(); }

Task<Result<Answer>> await_fact(Client& client, std::string pattern, Duration longest) {
  const Time deadline = client.executor().now() + longest;
  return await_answer(client.board(), query_from_datum(form(pattern)).value(), deadline, client.executor());
}

void wait_for_robots(Client& client, const std::vector<std::string>& names) {
  client.run(client.board().declare(runtime::runtime_relations()));
  for (const std::string& name : names) {
    client.run(await_fact(client, fmt::format("(agent {} ?kind ?host)", name), 10s));
    client.run(await_fact(client, fmt::format("(arm {} idle ?action)", name), 10s));
  }
}

void begin_turn(Client& client, const std::string& robot, std::uint64_t count) {
  // To and fro, also where two are stopped in turns: none comes to its limit.
  const char* side = count / 2 % 2 == 0 ? "right" : "left";
  client.run(client.board().tell(form(fmt::format("(request s{} {} (turn {} 120))", count, robot, side))));
  client.run(await_fact(client, fmt::format("(arm {} moving ?action)", robot), 5s));
}

double stop_turn(Client& client) {
  client.run(rest(client.executor()));
  const double told_us = now_us();
  client.run(client.board().tell(form("(stop bench \"a try\")")));
  return told_us;
}

void go_on(Client& client, std::uint64_t count) {
  client.run(await_fact(client, fmt::format("(reply s{} ?answer)", count), 5s));
  client.run(client.board().retract(form("(stop bench ?)")));
}

}  // namespace pizarra::bench
