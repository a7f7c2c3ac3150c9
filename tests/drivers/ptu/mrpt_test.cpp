// MRPT's driver for PTU-46 units, written by others and used with the real ones, against our emulator.

#include <future>
#include <gtest/gtest.h>
#include <mrpt/hwdrivers/CPtuDPerception.h>
#include <numbers>
#include <thread>

#include "blackboard/time/real_executor.hpp"
#include "drivers/line/pty_wire.hpp"
#include "drivers/simulation/controllers/serve.hpp"

namespace pizarra::ptu {
namespace {

constexpr double rad(double deg) { return deg * std::numbers::pi / 180; }

// The emulator on a thread of its own, as MRPT's calls block.
class Served {
 public:
  explicit Served(std::string_view model)
      : thread_([this, model] {
          simulation::PtuEmulator unit(executor_, *simulation::find_ptu_model(model));
          const auto line = line::PtyWire::make(executor_);
          const Job serving = executor_.spawn(simulation::serve(executor_, unit, **line));
          path_.set_value((*line)->path());
          executor_.run_until([] { return false; });
        }) {}
  ~Served() { executor_.stop(); }
  std::string path() { return path_.get_future().get(); }

 private:
  RealExecutor executor_;
  std::promise<std::string> path_;
  std::jthread thread_;
};

// MRPT tells its users on standard output what it is doing.
class Mrpt : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { ASSERT_TRUE(unit_.init(served_.path())); }
  double position(char axis) {
    double rad = 0;
    EXPECT_TRUE(unit_.absPosQ(axis, rad));
    return rad;
  }
  Served served_{GetParam()};
  mrpt::hwdrivers::CPtuDPerception unit_;
};

TEST_P(Mrpt, FindsResolutionAndLimits) {
  const simulation::PtuModel& model = *simulation::find_ptu_model(GetParam());
  EXPECT_NEAR(unit_.panResolution, rad(model.pan.arc_seconds / 3600), 1e-9);
  double low = 0;
  double high = 0;
  ASSERT_TRUE(unit_.minPosQ('T', low));
  ASSERT_TRUE(unit_.maxPosQ('T', high));
  EXPECT_NEAR(low, rad(model.tilt.low * model.tilt.arc_seconds / 3600), 1e-3);
  EXPECT_NEAR(high, rad(model.tilt.high * model.tilt.arc_seconds / 3600), 1e-3);
}

// The driver waits a second for an answer, so that the motions take a small part of one.
TEST_P(Mrpt, MovesBothAxesAndAwaitsTheirEnd) {
  ASSERT_TRUE(unit_.moveToAbsPos('P', rad(1)));
  ASSERT_TRUE(unit_.moveToAbsPos('T', rad(-0.8)));
  ASSERT_TRUE(unit_.aWait());
  EXPECT_NEAR(position('P'), rad(1), rad(0.06));
  EXPECT_NEAR(position('T'), rad(-0.8), rad(0.06));
  ASSERT_TRUE(unit_.moveToOffPos('P', rad(-0.5)));
  ASSERT_TRUE(unit_.aWait());
  EXPECT_NEAR(position('P'), rad(0.5), rad(0.12));
}

TEST_P(Mrpt, SetsAndReadsSpeeds) {
  ASSERT_TRUE(unit_.speed('P', rad(30)));
  double speed = 0;
  ASSERT_TRUE(unit_.speedQ('P', speed));
  EXPECT_NEAR(speed, rad(30), rad(0.06));
}

TEST_P(Mrpt, IsToldWhatLiesBeyondTheLimits) {
  EXPECT_FALSE(unit_.moveToAbsPos('T', rad(80)));
  bool limits = false;
  ASSERT_TRUE(unit_.enableLimitsQ(limits));
  EXPECT_TRUE(limits);
}

INSTANTIATE_TEST_SUITE_P(BothUnits, Mrpt, testing::Values("ptu46-17.5", "ptu46-70"),
                         [](const auto& unit) { return std::string(unit.param) == "ptu46-70" ? "Fine" : "Coarse"; });

}  // namespace
}  // namespace pizarra::ptu
