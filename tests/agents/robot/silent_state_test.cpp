// A controller that goes on hearing orders and says nothing of its arm any more: whichever it is, the arm does not move
// on unseen.

#include "drivers/arm/motoman/bsc_line.hpp"
#include "drivers/arm/motoman/ethernet_line.hpp"
#include "drivers/arm/motoman/host_link.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/arm/simple_message/motoros_arm.hpp"
#include "drivers/arm/simple_message/simple_arm.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "tests/agents/robot/robot_fixture.hpp"
#include "tests/drivers/arm/plain/plain_host.hpp"
#include "tests/drivers/arm/plain/plain_hses.hpp"
#include "tests/drivers/arm/plain/plain_motoros.hpp"
#include "tests/drivers/arm/plain/plain_simple.hpp"
#include "tests/drivers/arm/plain/plain_universal.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::robot {
namespace {

struct Hses {
  static constexpr const char* name = "Hses";
  static constexpr Duration longest = 150ms;  // of a silence
  VirtualExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  arm::PlainHses controller{executor, model};
  arm::HsesLink link{executor, controller};
  arm::MotomanArm driver{executor, link, model};
};

struct EthernetServer {
  static constexpr const char* name = "EthernetServer";
  static constexpr Duration longest = 600ms;  // a stop waits for the answer to the question before it
  VirtualExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  arm::PlainHost controller{model};
  line::WirePair wire{executor};
  Job serving{executor.spawn(arm::serve_ethernet(executor, controller, wire.far))};
  arm::EthernetLine line{executor, wire.near};
  arm::HostLink link{line};
  arm::MotomanArm driver{executor, link, model};
};

struct Bsc {
  static constexpr const char* name = "Bsc";
  static constexpr Duration longest = 3s;  // as above, at 9600 baud
  VirtualExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  arm::PlainHost controller{model};
  line::WirePair wire{executor};
  Job serving{executor.spawn(arm::serve_bsc(executor, controller, wire.far))};
  arm::BscLine line{executor, wire.near};
  arm::HostLink link{line};
  arm::MotomanArm driver{executor, link, model};
};

struct Universal {
  static constexpr const char* name = "Universal";
  static constexpr Duration longest = 150ms;
  VirtualExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("ur5e").value();
  arm::PlainUniversal controller{model};
  line::WirePair rtde{executor}, script{executor}, dashboard{executor};
  Job telling{executor.spawn(arm::serve_rtde(executor, controller, rtde.far))};
  Job running{executor.spawn(arm::serve_script(executor, controller, script.far))};
  Job answering{executor.spawn(arm::serve_dashboard(executor, controller, dashboard.far))};
  arm::UniversalArm driver{executor, {rtde.near, script.near, dashboard.near}, model};
};

struct SimpleMessage {
  static constexpr const char* name = "SimpleMessage";
  static constexpr Duration longest = 150ms;
  VirtualExecutor executor;
  const arm::ArmModel model = arm::crs_f3();
  arm::PlainSimple controller{model};
  line::WirePair motion{executor}, state{executor};
  Job moving{executor.spawn(arm::serve_motion(executor, controller, motion.far))};
  Job telling{executor.spawn(arm::serve_state(executor, controller, state.far))};
  arm::SimpleArm driver{executor, {.motion = motion.near, .state = state.near}, model};
};

struct Motoros {
  static constexpr const char* name = "Motoros";
  static constexpr Duration longest = 150ms;
  VirtualExecutor executor;
  const arm::ArmModel model = arm::shipped_arm("motoman-up6").value();
  arm::PlainMotoros controller{model};
  line::WirePair motion{executor}, state{executor};
  static constexpr double slow = 0.02;
  Job following{executor.spawn(arm::run_motoros(executor, controller, slow))};
  Job moving{executor.spawn(arm::serve_motion(executor, controller, motion.far))};
  Job telling{executor.spawn(arm::serve_state(executor, controller, state.far))};
  arm::MotorosArm driver{executor, {.motion = motion.near, .state = state.near}, model};
};

// The world of a simulated arm, at the other end of the device link.
class PlainWorld : public simulation::Link {
 public:
  PlainWorld(Executor& executor, const arm::ArmModel& model) : executor_(executor), model_(model) {}
  arm::PlainArm arm;
  Task<Result<simulation::Message>> call(Datum request, Duration timeout) override {
    const std::string_view what = request[1].text();
    if (what == "read" && arm.silent) {
      co_await sleep(executor_, timeout);
      co_return fail("disconnected", "the world does not answer");
    }
    if (what == "move") arm.move();
    if (what == "stop") arm.stop();
    simulation::Message message;
    if (what == "identify") message.head = list(Datum::string(model_.type));
    if (what == "read") {
      std::vector<Datum> joints;
      for (const double reading : model_.ready) joints.push_back(Datum::real(reading));
      const Datum moving = arm.moving ? "yes"_sym : "no"_sym;
      message.head = list(Datum::list(std::move(joints)), moving, "no"_sym, 80.0, "no"_sym);
    }
    co_return message;
  }

 private:
  Executor& executor_;
  const arm::ArmModel& model_;
};

struct Simulated {
  static constexpr const char* name = "Simulated";
  static constexpr Duration longest = 150ms;
  VirtualExecutor executor;
  const arm::ArmModel model = arm::crs_f3();
  PlainWorld controller{executor, model};
  simulation::SimulatedArm driver{controller};
};

template <class Controlled>
class SilentState : public testing::Test, protected Controlled {
 protected:
  void SetUp() override {
    this->executor.run_for(4s);
    Transaction request;
    request.tell(form("(request turn robot (turn right 90))"));
    ASSERT_TRUE(board.transact("user", request));
    this->executor.run_for(600ms);
    ASSERT_TRUE(this->controller.arm.moving);
    stops_before = this->controller.arm.stops;
  }
  std::string fact(std::string_view pattern) {
    const Answers answers = board.ask(query_from_datum(form(pattern)).value()).value();
    return answers.answers.empty() ? "" : write(answers.answers.front().facts.front().datum);
  }
  memory::MemoryBoard board{this->executor};
  RobotLife life{this->executor, board, this->driver, this->model};
  int stops_before = 0;
};

using Controllers = testing::Types<Hses, EthernetServer, Bsc, Universal, SimpleMessage, Motoros, Simulated>;
struct Names {
  template <class Controlled>
  static std::string GetName(int) {
    return Controlled::name;
  }
};
TYPED_TEST_SUITE(SilentState, Controllers, Names);

constexpr Duration a_beat = 30ms;  // and what was on its way

TYPED_TEST(SilentState, StopsTheArmThatMovesOnUnseenAndFailsItsMotion) {
  this->controller.arm.silent = true;
  this->executor.run_for(TypeParam::longest + a_beat);
  EXPECT_GT(this->controller.arm.stops, this->stops_before);
  EXPECT_FALSE(this->controller.arm.moving);
  this->executor.run_for(8s);
  EXPECT_TRUE(this->fact("(reply turn ?)").starts_with("(reply turn (fail ")) << this->fact("(reply turn ?)");
  EXPECT_TRUE(this->fact("(arm robot ? ?)").starts_with("(arm robot fault ")) << this->fact("(arm robot ? ?)");
}

TYPED_TEST(SilentState, StopsItAgainForAsLongAsNobodySeesThatItStands) {
  this->controller.arm.deaf = true;
  this->controller.arm.silent = true;
  this->executor.run_for(10s);
  const int stops = this->controller.arm.stops;
  EXPECT_GT(stops, this->stops_before);
  this->controller.arm.deaf = false;
  this->executor.run_for(8s);
  EXPECT_GT(this->controller.arm.stops, stops);
  EXPECT_FALSE(this->controller.arm.moving);
}

TYPED_TEST(SilentState, GoesOnWhereTheStateComesBack) {
  this->controller.arm.silent = true;
  this->executor.run_for(6s);
  this->controller.arm.silent = false;
  this->executor.run_for(6s);
  EXPECT_EQ(this->fact("(arm robot fault ?)"), "");
  Transaction request;
  request.tell(form("(request again robot (turn right 90))"));
  ASSERT_TRUE(this->board.transact("user", request));
  this->executor.run_for(600ms);
  EXPECT_TRUE(this->controller.arm.moving) << this->fact("(reply again ?)");
}

// A motion is not broken off while its controller tells its state.
TYPED_TEST(SilentState, LetsAMotionBeOfWhichTheStateComes) {
  this->executor.run_for(5s);
  EXPECT_TRUE(this->controller.arm.moving);
  EXPECT_EQ(this->controller.arm.stops, this->stops_before);
}

}  // namespace
}  // namespace pizarra::robot
