#include "drivers/ptu/ptu_driver.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "blackboard/time/random.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/drivers/ptu/wire_to_unit.hpp"

namespace pizarra::ptu {
namespace {

constexpr double deg_per_count = 185.1428 / 3600;
constexpr double half_a_count = deg_per_count / 2 + 1e-9;

class Driver : public testing::Test {
 protected:
  explicit Driver(std::string_view model = "ptu46-17.5") : unit(executor, *simulation::find_ptu_model(model)) {}

  template <class T>
  T ask(Task<T> task) {
    return run(executor, std::move(task));
  }
  void connect() {
    const Result<PanTiltRange> connected = ask(driver.connect());
    ASSERT_TRUE(connected) << describe(connected.error());
    range = *connected;
  }
  PanTiltReading read() {
    const Result<PanTiltReading> reading = ask(driver.read());
    EXPECT_TRUE(reading) << describe(reading.error());
    return reading.value_or(PanTiltReading{});
  }
  std::string outcome(Task<Result<void>> task) {
    const Result<void> done = ask(std::move(task));
    return done ? "ok" : done.error().symbol;
  }

  VirtualExecutor executor;
  simulation::PtuEmulator unit;
  WireToUnit wire{executor, unit};
  PtuDriver driver{executor, wire};
  PanTiltRange range{};
};

class FineDriver : public Driver {
 protected:
  FineDriver() : Driver("ptu46-70") {}
};

TEST_F(Driver, AsksTheUnitForItsResolutionLimitsAndSpeeds) {
  connect();
  EXPECT_NEAR(range.pan.low_deg, -3090 * deg_per_count, 1e-6);
  EXPECT_NEAR(range.tilt.high_deg, 604 * deg_per_count, 1e-6);
  EXPECT_NEAR(range.pan.resolution_deg * 60, 3.086, 0.001);
  EXPECT_NEAR(range.pan.top_speed_deg_s, 300, 0.1);
}

TEST_F(FineDriver, TheFinerUnitIsDrivenBySayingNothingOfIt) {
  connect();
  EXPECT_NEAR(range.pan.high_deg, 159.5, 0.1);
  EXPECT_NEAR(range.pan.top_speed_deg_s, 60, 0.1);
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 10)), "ok");
  executor.run_for(5s);
  EXPECT_NEAR(read().pan_deg, 10, range.pan.resolution_deg / 2 + 1e-9);
}

TEST_F(Driver, GoesWhereItIsSentAndSaysWhetherItIsOnItsWay) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 30)), "ok");
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::tilt, -12)), "ok");
  EXPECT_TRUE(read().moving);
  executor.run_for(5s);
  const PanTiltReading reading = read();
  EXPECT_FALSE(reading.moving);
  EXPECT_NEAR(reading.pan_deg, 30, range.pan.resolution_deg / 2);
  EXPECT_NEAR(unit.pan_deg(), reading.pan_deg, 1e-6);
  EXPECT_NEAR(unit.tilt_deg(), -12, range.tilt.resolution_deg / 2);
}

TEST_F(Driver, WhatAnotherHadSentItDoingIsStoppedWhenItIsConnectedTo) {
  connect();
  ASSERT_EQ(outcome(driver.set_speed(PanTiltAxis::pan, 0.05)), "ok");
  ASSERT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 120)), "ok");
  PtuDriver successor(executor, wire);
  ASSERT_TRUE(ask(successor.connect()));
  executor.run_for(1s);
  const double stands = unit.pan_deg();
  EXPECT_LT(stands, 60);
  executor.run_for(5s);
  EXPECT_EQ(unit.pan_deg(), stands);
}

TEST_F(Driver, RefusesAnglesBeyondTheUnitsOwnLimitsAndWhatIsNoNumber) {
  connect();
  wire.sent.clear();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 159)), "out-of-range");
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::tilt, -1e300)), "out-of-range");
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::tilt, std::numeric_limits<double>::quiet_NaN())), "not-finite");
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, std::numeric_limits<double>::infinity())), "not-finite");
  EXPECT_EQ(outcome(driver.set_speed(PanTiltAxis::pan, 1.01)), "out-of-range");
  EXPECT_EQ(wire.sent, "");
  const Result<void> beyond = ask(driver.move_to(PanTiltAxis::tilt, 60));
  EXPECT_EQ(beyond.error().subject, "tilt"_sym);
}

TEST_F(Driver, SpeedsArePartsOfTheUnitsOwnAndNeverNone) {
  connect();
  EXPECT_EQ(outcome(driver.set_speed(PanTiltAxis::pan, 1)), "ok");
  EXPECT_EQ(outcome(driver.set_speed(PanTiltAxis::tilt, 0)), "ok");
  EXPECT_TRUE(wire.sent.ends_with("PS5833 TS57 ")) << wire.sent;
}

TEST_F(Driver, WhereTheUnitCountsTheOtherWayRoundAnglesAndLimitsTurn) {
  PtuDriver turned(executor, wire, {.pan_reversed = true, .tilt_reversed = true});
  const Result<PanTiltRange> turned_range = ask(turned.connect());
  ASSERT_TRUE(turned_range);
  EXPECT_NEAR(turned_range->tilt.low_deg, -604 * deg_per_count, 1e-6);
  EXPECT_EQ(outcome(turned.move_to(PanTiltAxis::pan, 20)), "ok");
  executor.run_for(5s);
  EXPECT_NEAR(unit.pan_deg(), -20, 0.03);
  EXPECT_NEAR(ask(turned.read())->pan_deg, 20, 0.03);
}

TEST_F(Driver, ResetsTakeTheirTimeAndOthersWaitForTheirTurn) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 30)), "ok");
  std::optional<Result<void>> reset;
  const Job job = executor.spawn(keep(driver.reset_all(), reset));
  executor.run_for(1s);
  EXPECT_FALSE(reset);
  const PanTiltReading reading = read();
  EXPECT_TRUE(reset.has_value());
  EXPECT_TRUE(reset->has_value());
  EXPECT_EQ(reading.pan_deg, 0);
}

TEST_F(Driver, HaltStopsBothAxes) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 150)), "ok");
  executor.run_for(1s);
  EXPECT_EQ(outcome(driver.halt()), "ok");
  executor.run_for(1s);
  EXPECT_FALSE(read().moving);
  EXPECT_LT(read().pan_deg, 100);
}

TEST_F(Driver, AUnitThatDoesNotEchoIsDrivenTheSame) {
  wire.to_unit = [](std::string_view bytes) { return std::string(bytes == "EE " ? "ED " : bytes); };
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::tilt, 5)), "ok");
  executor.run_for(2s);
  EXPECT_NEAR(read().tilt_deg, 5, 0.03);
}

TEST_F(Driver, HalfACommandLeftOnTheLineDoesNotMoveTheUnit) {
  unit.receive("PP10");
  connect();
  EXPECT_EQ(read().pan_deg, 0);
  EXPECT_FALSE(read().moving);
}

TEST_F(Driver, AnAnswerThatNeverEndsFailsAndNothingIsKnownUntilConnectedAgain) {
  connect();
  wire.from_unit = [](std::string_view bytes) { return std::string(bytes.substr(0, bytes.size() / 2)); };
  EXPECT_EQ(outcome(driver.halt()), "no-answer");
  EXPECT_EQ(outcome(driver.halt()), "disconnected");
  wire.from_unit = nullptr;
  connect();
  EXPECT_EQ(outcome(driver.halt()), "ok");
}

TEST_F(Driver, AnAnswerThatComesTooLateIsNotTakenForAnothers) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 20)), "ok");
  executor.run_for(5s);
  // The answers to an earlier client's questions, still on their way.
  wire.from_unit = [](std::string_view bytes) {
    const bool echo = bytes.ends_with(' ');
    return (echo ? "TP * Current Tilt position is 99\r\n" : "") + std::string(bytes);
  };
  const PanTiltReading reading = read();
  EXPECT_NEAR(reading.pan_deg, 20, 0.03);
}

TEST_F(Driver, GarbageOnTheLineEndsInOneClearFailure) {
  connect();
  wire.from_unit = [](std::string_view) { return std::string("\xff\x00\x07 nonsense without an end", 27) + "\r\n"; };
  const Result<PanTiltReading> reading = ask(driver.read());
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "bad-reply");
  EXPECT_NE(reading.error().sentence.find("\\xff\\x00\\x07"), std::string::npos) << reading.error().sentence;
}

TEST_F(Driver, ALineThatIsNeverQuietIsRefusedInTime) {
  const Job noise = executor.spawn([](Executor& clock, WireToUnit& line) -> Task<void> {
    while (true) {
      line.hear("x");
      co_await sleep(clock, 20ms);
    }
  }(executor, wire));
  const Result<PanTiltRange> connected = ask(driver.connect());
  ASSERT_FALSE(connected);
  EXPECT_EQ(connected.error().symbol, "bad-reply");
}

TEST_F(Driver, APulledPlugFailsAtOnceAlsoInMidMove) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 100)), "ok");
  wire.pull();
  const Time before = executor.now();
  EXPECT_EQ(ask(driver.read()).error().symbol, "disconnected");
  EXPECT_LT(executor.now() - before, 10ms);
}

TEST_F(Driver, AUnitThatLostItsPowerInMidMoveIsNoticedAndAskedAnew) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 100)), "ok");
  executor.run_for(500ms);
  unit.power(false);
  EXPECT_EQ(ask(driver.read()).error().symbol, "no-answer");
  unit.power(true);
  executor.run_for(60s);
  connect();
  EXPECT_NEAR(read().pan_deg, 0, 1e-9);
}

TEST_F(Driver, APowerCutThatNobodyWaitedThroughIsNoticedAtTheNextCommand) {
  connect();
  EXPECT_EQ(outcome(driver.move_to(PanTiltAxis::pan, 10)), "ok");
  executor.run_for(5s);
  unit.power(false);
  unit.power(true);
  executor.run_for(60s);
  EXPECT_EQ(ask(driver.read()).error().symbol, "restarted");
  EXPECT_EQ(outcome(driver.halt()), "disconnected");
}

// Whatever a bad line does to the bytes, a reading that is given is true. (Of digits that vanish without a trace nobody
// could know: the protocol has no checksum.)
TEST_F(Driver, OverALineThatGarblesAndFallsSilentNoReadingIsFalse) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto spoil = [&random](std::string_view bytes) {
      std::string out;
      if (random.uniform(0, 1) < 0.01) return out;
      for (const char c : bytes) {
        const bool garbled = random.uniform(0, 1) < 0.002;
        out += garbled ? static_cast<char>(random.below(256) | 0x80) : c;
      }
      return out;
    };
    wire.to_unit = spoil;
    wire.from_unit = spoil;
    int readings = 0;
    for (int i = 0; i < 40; ++i) {
      if (!ask(driver.connect())) continue;
      const double wanted = random.uniform(-100, 100);
      if (!ask(driver.move_to(PanTiltAxis::pan, wanted))) continue;
      executor.run_for(10s);
      const Result<PanTiltReading> reading = ask(driver.read());
      if (!reading) continue;
      ++readings;
      EXPECT_NEAR(reading->pan_deg, wanted, half_a_count) << "seed " << seed << ", round " << i;
      EXPECT_NEAR(reading->pan_deg, unit.pan_deg(), 1e-6) << "seed " << seed << ", round " << i;
    }
    EXPECT_GT(readings, 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pizarra::ptu
