// What every arm driver does with what is wrong: one failure, which has a symbol, a sentence, and the axis where it is
// about one; and where the arm is is known, or said not to be.

#include <cmath>
#include <limits>

#include "blackboard/time/random.hpp"
#include "drivers/arm/meeting.hpp"
#include "lisp/writer.hpp"
#include "tests/drivers/arm/driven_cells.hpp"

namespace pizarra::arm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Duration patience = 6s;  // with a controller that is not there

template <class Cell>
class EveryArm : public testing::Test, protected Cell {
 protected:
  using Cell::arm;
  using Cell::ask;
  using Cell::cabinet;
  using Cell::executor;

  void SetUp() override { ASSERT_EQ(this->connect(), ""); }

  // Nothing but this failure, with a sentence.
  void expect_failure(const Result<void>& done, const std::string& symbol, const std::string& what) {
    ASSERT_FALSE(done) << what;
    EXPECT_EQ(done.error().symbol, symbol) << what << ": " << done.error().sentence;
    EXPECT_FALSE(done.error().sentence.empty()) << what;
  }
  Result<void> send_to(const Joints& there, double speed = 1) { return ask(arm.start_move({there}, speed)); }
  // On the far side of where it stands, by a third of its axis' range at most.
  Joints elsewhere() {
    const Axis& axis = this->model().axes[0];
    Joints there = cabinet_joints();
    const double way = (axis.limits.high - axis.limits.low) / 4;
    there[0] += there[0] > (axis.limits.high + axis.limits.low) / 2 ? -way : way;
    return there;
  }
  Joints cabinet_joints() { return ask(cabinet.read()).joints; }
  // Says nothing, or why; and either within a time that somebody waits for.
  Result<ArmReading> read_in_time(const std::string& what) {
    const Time before = executor.now();
    const Result<ArmReading> reading = this->read();
    EXPECT_LE(executor.now() - before, patience) << what;
    if (!reading) {
      const std::string& symbol = reading.error().symbol;
      EXPECT_TRUE(symbol == "disconnected" || symbol == "bad-reply" || symbol == "refused") << what << ": " << symbol;
      EXPECT_FALSE(reading.error().sentence.empty()) << what;
    }
    return reading;
  }
  // Whatever was the matter is over: it is found again, is where it says, and can be moved and stopped.
  void expect_recovered(const std::string& what) {
    executor.run_for(3s);
    static_cast<void>(cabinet.obey("alarm 0"));
    static_cast<void>(cabinet.obey("servo on"));
    executor.run_for(1s);
    ASSERT_EQ(this->connect(), "") << what;
    const Result<ArmReading> reading = this->wait();
    ASSERT_TRUE(reading) << what;
    EXPECT_TRUE(are_same_place(reading->joints, cabinet_joints(), 0.01)) << what;
    const Joints there = elsewhere();
    const Result<void> sent_off = send_to(there);
    ASSERT_TRUE(sent_off) << what << ": " << describe(sent_off.error());
    const Result<ArmReading> ended = this->wait();
    ASSERT_TRUE(ended) << what;
    EXPECT_TRUE(are_same_place(ended->joints, there, 0.05)) << what;
  }
};

TYPED_TEST_SUITE(EveryArm, DrivenCells, DrivenCellNames);

TYPED_TEST(EveryArm, RefusesWhatIsBeyondAnAxisAndNamesItAndSendsNothing) {
  const std::size_t sent = this->orders();
  for (std::size_t axis = 0; axis < this->model().axes.size(); ++axis) {
    const Range limits = this->model().axes[axis].limits;
    for (const double beyond : {limits.low - 0.1, limits.high + 0.1, -1e18, 1e300, nan, infinite, -infinite}) {
      Joints there = this->model().ready;
      there[axis] = beyond;
      const Result<void> done = this->send_to(there);
      this->expect_failure(done, std::isfinite(beyond) ? "joint-limit" : "not-finite", std::to_string(beyond));
      EXPECT_EQ(done.error().subject, to_datum(axis + 1)) << beyond;
    }
  }
  EXPECT_EQ(this->cabinet.moves(), 0u);
  EXPECT_LE(this->orders(), sent) << "something went over the line";
}

TYPED_TEST(EveryArm, RefusesMovesThatAreNone) {
  const Joints ready = this->model().ready;
  for (const double speed : {nan, infinite, -infinite})
    this->expect_failure(this->send_to(ready, speed), "not-finite", "");
  for (const double speed : {0.0, -1.0, 1.001, 1e300})
    this->expect_failure(this->send_to(ready, speed), "bad-request", "");
  this->expect_failure(this->ask(this->arm.start_move({}, 1)), "bad-request", "nowhere");
  this->expect_failure(this->send_to(Joints{0, 0}), "bad-joints", "two axes");
  Joints beyond = ready;
  beyond[0] = 1e6;
  this->expect_failure(this->ask(this->arm.start_move({ready, beyond}, 1)), "joint-limit", "the second of two");
  EXPECT_EQ(this->cabinet.moves(), 0u);
}

TYPED_TEST(EveryArm, RefusesAnOpeningThatIsNoNumber) {
  for (const double opening : {nan, infinite, -infinite}) {
    this->expect_failure(this->ask(this->arm.start_gripper(opening)), "not-finite", "");
  }
  EXPECT_TRUE(this->read());
}

TYPED_TEST(EveryArm, DoesNotMoveWhileItIsLockedAndSaysWhy) {
  for (const auto& [lock, unlock] : {std::pair("pendant on", "pendant off"), std::pair("estop on", "estop off"),
                                     std::pair("hold on", "hold off"), std::pair("alarm 4321", "alarm 0")}) {
    ASSERT_TRUE(this->cabinet.obey(lock));
    this->executor.run_for(100ms);
    const Joints before = this->cabinet_joints();
    this->expect_failure(this->send_to(this->elsewhere()), "not-in-control", lock);
    this->executor.run_for(1s);
    EXPECT_TRUE(are_same_place(this->cabinet_joints(), before)) << lock;
    ASSERT_TRUE(this->cabinet.obey(unlock));
    this->expect_recovered(lock);
  }
}

TYPED_TEST(EveryArm, SaysAtRestWhyItWouldNotMoveAndWhenItWouldAgain) {
  for (const auto& [lock, unlock] : {std::pair("pendant on", "pendant off"), std::pair("estop on", "estop off"),
                                     std::pair("alarm 4321", "alarm 0")}) {
    ASSERT_TRUE(this->cabinet.obey(lock));
    static_cast<void>(this->read());
    this->executor.run_for(1s);
    static_cast<void>(this->read());
    this->executor.run_for(100ms);
    const Result<ArmReading> locked = this->read();
    ASSERT_TRUE(locked) << lock;
    ASSERT_TRUE(locked->trouble) << lock;
    EXPECT_EQ(locked->trouble->why.symbol, "not-in-control") << lock;
    ASSERT_TRUE(this->cabinet.obey(unlock));
    this->expect_recovered(lock);
    EXPECT_FALSE(this->read()->trouble) << unlock;
  }
}

TYPED_TEST(EveryArm, WhatEndsAMoveIsSaidAndItIsNotTakenUpByItself) {
  for (const auto& [ends, undoes] : {std::pair("pendant on", "pendant off"), std::pair("estop on", "estop off"),
                                     std::pair("hold on", "hold off"), std::pair("alarm 4321", "alarm 0")}) {
    ASSERT_TRUE(this->send_to(this->elsewhere(), 0.3)) << ends;
    this->executor.run_for(300ms);
    ASSERT_TRUE(this->read()) << ends;
    ASSERT_TRUE(this->cabinet.obey(ends));
    const Result<ArmReading> ended = this->wait();
    ASSERT_TRUE(ended) << ends;
    EXPECT_TRUE(ended->stopped) << ends;
    ASSERT_TRUE(ended->why_stopped) << ends;
    EXPECT_EQ(ended->why_stopped->symbol, "stopped") << ends;
    EXPECT_FALSE(ended->why_stopped->sentence.empty()) << ends;
    ASSERT_TRUE(this->cabinet.obey(undoes));
    this->executor.run_for(3s);
    EXPECT_TRUE(are_same_place(this->cabinet_joints(), ended->joints, 0.05)) << ends << ": it went on by itself";
    this->expect_recovered(ends);
  }
}

TYPED_TEST(EveryArm, ALineCutInMidMoveIsADisconnectionAndTheArmIsFoundAgain) {
  ASSERT_TRUE(this->send_to(this->elsewhere(), 0.3));
  this->executor.run_for(300ms);
  this->cut(true);
  this->executor.run_for(600ms);
  const Result<ArmReading> reading = this->read_in_time("cut");
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "disconnected") << reading.error().sentence;
  EXPECT_FALSE(this->send_to(this->model().ready));
  this->cut(false);
  this->expect_recovered("cut");
}

TYPED_TEST(EveryArm, PowerLostInMidMoveIsSilenceAndWhatItWasDoingIsOver) {
  ASSERT_TRUE(this->send_to(this->elsewhere(), 0.3));
  this->executor.run_for(300ms);
  ASSERT_TRUE(this->cabinet.obey("power off"));
  this->executor.run_for(1s);
  const Result<ArmReading> silent = this->read_in_time("no power");
  ASSERT_FALSE(silent);
  EXPECT_EQ(silent.error().symbol, "disconnected") << silent.error().sentence;
  const Joints stands = this->cabinet_joints();
  ASSERT_TRUE(this->cabinet.obey("power on"));
  this->executor.run_for(3s);
  static_cast<void>(this->read_in_time("power again"));
  EXPECT_TRUE(are_same_place(this->cabinet_joints(), stands)) << "it went on by itself";
  this->expect_recovered("power");
}

TYPED_TEST(EveryArm, GarbageFromTheControllerIsOneFailureUntilItEnds) {
  this->spoil([](const std::string& said) { return std::string(said.size(), '\xff') + "\r\n"; });
  this->executor.run_for(1s);
  EXPECT_FALSE(this->read_in_time("garbage"));
  const Time before = this->executor.now();
  EXPECT_FALSE(this->send_to(this->elsewhere()));
  EXPECT_LE(this->executor.now() - before, patience);
  this->spoil(nullptr);
  this->expect_recovered("garbage");
}

// Half of one, and nothing after it.
TYPED_TEST(EveryArm, HalfAReplyIsNoReply) {
  bool begun = false;
  this->spoil(
      [&begun](const std::string& said) { return said.substr(0, std::exchange(begun, true) ? 0 : said.size() / 2); });
  this->executor.run_for(1s);
  EXPECT_FALSE(this->read_in_time("half a reply"));
  this->spoil(nullptr);
  this->expect_recovered("half a reply");
}

// Whatever becomes of what the controller says, an answer comes in time, says finite numbers or why not, and ends.
TYPED_TEST(EveryArm, WhateverBecomesOfItsWordsEveryCallEndsInOneWay) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    this->spoil([&random](std::string said) {
      if (said.empty() || random.uniform(0, 1) < 0.7) return said;
      for (std::uint64_t edits = random.below(3); edits > 0; --edits) {
        said[random.below(said.size())] = static_cast<char>(random.below(256));
      }
      said.resize(random.below(said.size() + 1));
      return said;
    });
    for (int i = 0; i < 20; ++i) {
      const std::string what = "seed " + std::to_string(seed) + ", call " + std::to_string(i);
      const Result<ArmReading> reading = this->read_in_time(what);
      for (std::size_t axis = 0; reading && axis < reading->joints.size(); ++axis) {
        EXPECT_TRUE(std::isfinite(reading->joints[axis])) << what;
      }
      const Time before = this->executor.now();
      const Result<void> sent_off = this->send_to(this->elsewhere());
      EXPECT_LE(this->executor.now() - before, 2 * patience) << what;
      if (!sent_off) {
        EXPECT_FALSE(sent_off.error().sentence.empty()) << what;
      }
      this->executor.run_for(500ms);
      if (!reading) static_cast<void>(this->connect());
    }
    this->spoil(nullptr);
    this->expect_recovered("seed " + std::to_string(seed));
  }
}

// As by an agent that was killed: its controller goes on without it.
TYPED_TEST(EveryArm, WhatMovesForNobodyIsStoppedWhenItIsMetAndWhereItStandsIsKnown) {
  ASSERT_TRUE(this->send_to(this->elsewhere(), 0.1));
  this->executor.run_for(300ms);
  this->begin_anew();
  const Result<ArmMeeting> met = this->ask(meet_arm(this->executor, this->arm, this->model()));
  ASSERT_TRUE(met) << describe(met.error());
  EXPECT_TRUE(met->was_stopped);
  EXPECT_FALSE(met->reading.moving);
  const Joints stands = this->cabinet_joints();
  EXPECT_TRUE(are_same_place(met->reading.joints, stands, 0.01));
  this->executor.run_for(5s);
  EXPECT_TRUE(are_same_place(this->cabinet_joints(), stands)) << "it went on";
  this->expect_recovered("began anew");
  this->begin_anew();
  const Result<ArmMeeting> at_rest = this->ask(meet_arm(this->executor, this->arm, this->model()));
  ASSERT_TRUE(at_rest) << describe(at_rest.error());
  EXPECT_FALSE(at_rest->was_stopped);
}

// It is another arm, or one that somebody must bring back first.
TYPED_TEST(EveryArm, AnArmThatStandsWhereTheFilesCannotIsNotTaken) {
  ASSERT_TRUE(this->send_to(this->elsewhere()));
  const Result<ArmReading> there = this->wait();
  ASSERT_TRUE(there);
  ArmModel narrow = this->model();
  narrow.axes[0].limits = {there->joints[0] + 2, there->joints[0] + 20};
  const Result<ArmMeeting> met = this->ask(meet_arm(this->executor, this->arm, narrow));
  ASSERT_FALSE(met);
  EXPECT_EQ(met.error().symbol, "joint-limit");
  EXPECT_EQ(met.error().subject, to_datum(1));
}

TYPED_TEST(EveryArm, ACallThatIsCancelledLeavesNothingBehind) {
  for (int i = 0; i < 20; ++i) {
    {
      const Job cut_off = this->executor.spawn(
          [](ArmDriver& driven) -> Task<void> { static_cast<void>(co_await driven.read()); }(this->arm));
      this->executor.run_for(Duration(i * 37));
    }
    const Result<ArmReading> reading = this->read();
    ASSERT_TRUE(reading) << i << ": " << describe(reading.error());
    EXPECT_TRUE(are_same_place(reading->joints, this->cabinet_joints(), 0.01)) << i;
  }
}

}  // namespace
}  // namespace pizarra::arm
