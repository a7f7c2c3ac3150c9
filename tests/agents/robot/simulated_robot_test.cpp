// The agent over the simulated cell's arm, which has ramps, steps and a real gripper.

#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/world.hpp"
#include "tests/agents/robot/robot_fixture.hpp"

namespace pizarra::robot {
namespace {

TEST(SimulatedRobot, ReachesTheTableGripsACubeAndLiftsIt) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  simulation::WorldConfig config;
  config.cubes.push_back(
      {.name = "circle", .mark = simulation::Mark::circle, .x_mm = 450, .y_mm = 0, .yaw_deg = 0, .on = ""});
  simulation::World world(executor, config);
  simulation::LocalLink link(world);
  simulation::SimulatedArm arm(link);
  RobotLife life(executor, board, arm);
  const auto call = [&](std::string_view operation, const std::string& id) {
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), "robot"_sym, form(operation)));
    EXPECT_TRUE(board.transact("user", request)) << operation;
    const Query query = query_from_datum(form(fmt::format("(reply {} ?answer)", id))).value();
    const Time deadline = executor.now() + 30s;
    executor.run_until([&] { return !board.ask(query)->answers.empty() || executor.now() > deadline; });
    const Answers answers = board.ask(query).value();
    return answers.answers.empty() ? "" : write(answers.answers.front().facts.front().datum[2]);
  };
  executor.run_for(1s);
  int asked = 0;
  for (const std::string_view operation :
       {"(gripper 84)", "(extend keep-height 80)", "(move-v down 200)", "(move-v down 180)", "(gripper 40)",
        "(move-v up 150)", "(turn right 10)", "(turn-wrist left 10)", "(home)", "(ready)"}) {
    EXPECT_EQ(call(operation, fmt::format("r{}", ++asked)), "(ok true)") << operation;
  }
  const Query opening = query_from_datum(form("(gripper robot ?mm)")).value();
  EXPECT_NEAR(board.ask(opening)->answers.front().facts.front().datum[2].number(), 60, 1.5);
}

TEST(SimulatedRobot, AJogThatIsHeldNoMoreStandsWithinItsOverrunAlthoughItHasToBrake) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  simulation::World world(executor, simulation::WorldConfig{});
  simulation::LocalLink link(world);
  simulation::SimulatedArm arm(link);
  RobotLife life(executor, board, arm);
  executor.run_for(1s);
  const auto tell = [&](const std::string& fact) {
    Transaction telling;
    telling.tell(form(fact));
    ASSERT_TRUE(board.transact("user", telling)) << fact;
  };
  const auto grip = [&] {
    const Query pose = query_from_datum(form("(arm-pose robot ?x ?y ?z ?rx ?ry ?rz)")).value();
    const Datum fact = board.ask(pose)->answers.front().facts.front().datum;
    return Eigen::Vector3d(fact[2].number(), fact[3].number(), fact[4].number());
  };
  tell("(hold robot user 0)");
  tell("(request j1 robot (jog left 250))");
  for (int count = 1; count <= 40; ++count) {
    executor.run_for(50ms);
    tell(fmt::format("(hold robot user {})", count));
  }
  const Eigen::Vector3d last = grip();
  executor.run_for(300ms);
  const Eigen::Vector3d at_deadline = grip();
  executor.run_for(1s);
  // The pose told is up to a tenth of a second old.
  EXPECT_LE((grip() - last).norm(), 10 + 3);
  EXPECT_GT((grip() - last).norm(), 5);
  EXPECT_LE((grip() - at_deadline).norm(), 0.5) << "it stood 50 ms after the deadline";
}

}  // namespace
}  // namespace pizarra::robot
