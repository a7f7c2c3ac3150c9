// The robot agent over an emulated Universal Robots controller, in virtual time.

#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"
#include "tests/agents/robot/robot_fixture.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::robot {
namespace {

TEST(UniversalRobot, DoesTheOperationsOfEveryArm) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  const arm::ArmModel model = arm::shipped_arm("ur5e").value();
  simulation::MovingArm body(executor, model);
  simulation::ArmCabinet cabinet(executor, body, model);
  simulation::UrEmulator emulator(cabinet);
  line::WirePair rtde(executor), script(executor), dashboard(executor);
  const Job telling = executor.spawn(simulation::serve_rtde(executor, emulator, rtde.far));
  const Job running =
      executor.spawn(simulation::serve_interface(executor, emulator, simulation::UrInterface::secondary, script.far));
  const Job answering = executor.spawn(simulation::serve_dashboard(executor, emulator, dashboard.far));
  arm::UniversalArm arm(executor, {rtde.near, script.near, dashboard.near}, model);
  const RobotLife life(executor, board, arm, model);
  executor.run_for(2s);
  int asked = 0;
  for (const std::string_view operation :
       {"(gripper 84)", "(extend keep-height 60)", "(move-v down 80)", "(move-h left 100)", "(move-h right 200)",
        "(finish stop)", "(turn right 15)", "(turn-wrist left 10)", "(retract 40)", "(ready)", "(home)"}) {
    const std::string id = fmt::format("r{}", ++asked);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), "robot"_sym, form(operation)));
    ASSERT_TRUE(board.transact("user", request));
    const Query query = query_from_datum(form(fmt::format("(reply {} ?answer)", id))).value();
    const Time deadline = executor.now() + 60s;
    executor.run_until([&] { return !board.ask(query)->answers.empty() || executor.now() > deadline; });
    const Answers answers = board.ask(query).value();
    ASSERT_FALSE(answers.answers.empty()) << operation;
    EXPECT_EQ(write(answers.answers.front().facts.front().datum[2]), "(ok true)") << operation;
    executor.run_for(300ms);
    const Query stray = query_from_datum(form("(arm robot ? \"MOVED_BY_ITSELF\")")).value();
    EXPECT_TRUE(board.ask(stray)->answers.empty()) << operation;
  }
}

}  // namespace
}  // namespace pizarra::robot
