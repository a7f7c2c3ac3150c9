// Every driver on a controller that was written from the protocol's document alone: where the arm is and where it is
// sent stands on the wire as the document says, not only as an emulator here has it.

#include <gtest/gtest.h>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/bsc_line.hpp"
#include "drivers/arm/motoman/ethernet_line.hpp"
#include "drivers/arm/motoman/host_link.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/arm/route.hpp"
#include "drivers/arm/simple_message/simple_arm.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "tests/drivers/arm/driven_arm.hpp"
#include "tests/drivers/arm/plain/plain_host.hpp"
#include "tests/drivers/arm/plain/plain_hses.hpp"
#include "tests/drivers/arm/plain/plain_simple.hpp"
#include "tests/drivers/arm/plain/plain_universal.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::arm {
namespace {

struct OnHses {
  static constexpr const char* name = "Hses";
  VirtualExecutor executor;
  const ArmModel model = shipped_arm("motoman-up6").value();
  PlainHses controller{executor, model};
  HsesLink link{executor, controller};
  MotomanArm arm{executor, link, model};
};

struct OnEthernetServer {
  static constexpr const char* name = "EthernetServer";
  VirtualExecutor executor;
  const ArmModel model = shipped_arm("motoman-up6").value();
  PlainHost controller{model};
  line::WirePair wire{executor};
  Job serving{executor.spawn(serve_ethernet(executor, controller, wire.far))};
  EthernetLine line{executor, wire.near};
  HostLink link{line};
  MotomanArm arm{executor, link, model};
};

struct OnBsc {
  static constexpr const char* name = "Bsc";
  VirtualExecutor executor;
  const ArmModel model = shipped_arm("motoman-up6").value();
  PlainHost controller{model};
  line::WirePair wire{executor};
  Job serving{executor.spawn(serve_bsc(executor, controller, wire.far))};
  BscLine line{executor, wire.near};
  HostLink link{line};
  MotomanArm arm{executor, link, model};
};

struct OnUniversal {
  static constexpr const char* name = "Universal";
  VirtualExecutor executor;
  const ArmModel model = shipped_arm("ur5e").value();
  PlainUniversal controller{model};
  line::WirePair rtde{executor}, script{executor}, dashboard{executor};
  Job telling{executor.spawn(serve_rtde(executor, controller, rtde.far))};
  Job running{executor.spawn(serve_script(executor, controller, script.far))};
  Job answering{executor.spawn(serve_dashboard(executor, controller, dashboard.far))};
  UniversalArm arm{executor, {rtde.near, script.near, dashboard.near}, model};
};

template <line::ByteOrder order>
struct OnSimple {
  static constexpr const char* name = order == line::ByteOrder::little ? "SimpleMessage" : "SimpleMessageBigEndian";
  VirtualExecutor executor;
  const ArmModel model = crs_f3();
  PlainSimple controller{model, order};
  line::WirePair motion{executor}, state{executor};
  Job moving{executor.spawn(serve_motion(executor, controller, motion.far))};
  Job telling{executor.spawn(serve_state(executor, controller, state.far))};
  SimpleArm arm{executor, {.motion = motion.near, .state = state.near, .order = order}, model};
};

template <class On>
struct Bench : DrivenArm<Bench<On>>, On {};

template <class On>
class PlainControllers : public testing::Test, protected Bench<On> {};

using All = testing::Types<OnHses, OnEthernetServer, OnBsc, OnUniversal, OnSimple<line::ByteOrder::little>,
                           OnSimple<line::ByteOrder::big>>;
struct Names {
  template <class On>
  static std::string GetName(int) {
    return On::name;
  }
};
TYPED_TEST_SUITE(PlainControllers, All, Names);

TYPED_TEST(PlainControllers, TheArmIsWhereTheControllerSaysAndGoesWhereItIsSent) {
  ASSERT_EQ(this->connect(), "");
  const Result<ArmReading> before = this->read();
  ASSERT_TRUE(before) << describe(before.error());
  EXPECT_TRUE(are_same_place(before->joints, this->model.ready));
  Joints there = this->model.ready;
  for (std::size_t axis = 0; axis < there.size(); ++axis) {
    if (this->model.axes[axis].role != Role::track) there[axis] += axis % 2 == 0 ? 7.5 : -4.25;
  }
  ASSERT_EQ(this->move({there}, 0.5), "");
  EXPECT_TRUE(are_same_place(this->controller.arm.sent, there));
  this->executor.run_for(600ms);
  EXPECT_TRUE(this->read()->moving);
  this->controller.arrive();
  const Result<ArmReading> after = this->wait();
  ASSERT_TRUE(after) << describe(after.error());
  EXPECT_FALSE(after->stopped);
  EXPECT_TRUE(are_same_place(after->joints, there));
}

TYPED_TEST(PlainControllers, AStopReachesItAndTheMoveEndsWhereTheArmIs) {
  ASSERT_EQ(this->connect(), "");
  Joints there = this->model.ready;
  there[0] += 20;
  ASSERT_EQ(this->move({there}), "");
  this->executor.run_for(300ms);
  const int stops = this->controller.arm.stops;
  EXPECT_EQ(this->outcome(this->arm.stop()), "");
  this->executor.run_for(50ms);
  EXPECT_GT(this->controller.arm.stops, stops);
  const Result<ArmReading> after = this->wait();
  ASSERT_TRUE(after) << describe(after.error());
  EXPECT_TRUE(after->stopped);
  EXPECT_TRUE(are_same_place(after->joints, this->model.ready));
}

// As a mock of the High Speed Ethernet Server does that takes a move for something else.
TYPED_TEST(PlainControllers, AMoveThatTheControllerEndsElsewhereHasStopped) {
  ASSERT_EQ(this->connect(), "");
  Joints there = this->model.ready;
  there[0] += 20;
  ASSERT_EQ(this->move({there}), "");
  this->executor.run_for(300ms);
  this->controller.arm.moving = false;
  const Result<ArmReading> after = this->wait();
  ASSERT_TRUE(after) << describe(after.error());
  EXPECT_TRUE(after->stopped);
  ASSERT_TRUE(after->why_stopped);
  EXPECT_EQ(after->why_stopped->symbol, "stopped");
}

}  // namespace
}  // namespace pizarra::arm
