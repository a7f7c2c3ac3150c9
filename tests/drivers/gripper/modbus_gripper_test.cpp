#include "drivers/gripper/modbus_gripper.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "blackboard/time/real_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/line/tcp_port.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/controllers/gripper/modbus_server.hpp"
#include "tests/run_task.hpp"

namespace pizarra::gripper {
namespace {

// Fingers with a thing of this width between them.
class Fingers : public simulation::MovingArm {
 public:
  using simulation::MovingArm::MovingArm;
  double thing_mm = 0;
  Task<Result<void>> start_gripper(double opening_mm) override {
    return simulation::MovingArm::start_gripper(std::max(opening_mm, thing_mm));
  }
};

// In real time: libmodbus has the sockets of both ends.
class Modbus : public testing::Test {
 protected:
  explicit Modbus(forms::GripperSetup laid_out = {}) : setup(std::move(laid_out)) {}
  void SetUp() override {
    server = std::move(simulation::ModbusServer::listen(executor, gripper, "127.0.0.1", 0).value());
    client.emplace(executor, "localhost", server->port(), setup.unit);
    driver.emplace(executor, *client, setup);
  }
  template <class T>
  T ask(Task<T> task) {
    return run(executor, std::move(task));
  }
  std::string outcome(Task<Result<void>> task) {
    const Result<void> done = ask(std::move(task));
    return done ? "" : done.error().symbol;
  }
  Result<GripperReading> read() { return ask(driver->read()); }
  Result<GripperReading> wait() {
    Result<GripperReading> reading = read();
    while (reading && reading->moving) {
      ask(nap());
      reading = read();
    }
    return reading;
  }
  Task<bool> nap() {
    co_await sleep(executor, 20ms);
    co_return true;
  }

  forms::GripperSetup setup;
  RealExecutor executor;
  Fingers body{executor, arm::crs_f3()};
  simulation::GripperEmulator gripper{executor, body, setup};
  std::unique_ptr<simulation::ModbusServer> server;
  std::optional<ModbusClient> client;
  std::optional<ModbusGripper> driver;
};

constexpr double one_count_mm = 100.0 / 255;

TEST_F(Modbus, IsActivatedClosesOpensAndSaysHowWideItIs) {
  ASSERT_EQ(outcome(driver->connect()), "");
  for (const double opening : {70.0, 90.0}) {
    ASSERT_EQ(outcome(driver->start(opening)), "");
    EXPECT_TRUE(read()->moving);
    const Result<GripperReading> reading = wait();
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->opening_mm, opening, one_count_mm);
    EXPECT_FALSE(reading->gripped);
  }
  ASSERT_EQ(outcome(driver->start(90)), "") << "where it is already";
  EXPECT_NEAR(wait()->opening_mm, 90, one_count_mm);
  EXPECT_EQ(outcome(driver->start(1e300)), "") << "as far as it opens";
  EXPECT_NEAR(wait()->opening_mm, 100, one_count_mm);
}

TEST_F(Modbus, SaysThatSomethingIsBetweenItsFingers) {
  body.thing_mm = 80;
  ASSERT_EQ(outcome(driver->connect()), "");
  ASSERT_EQ(outcome(driver->start(40)), "");
  const Result<GripperReading> reading = wait();
  ASSERT_TRUE(reading);
  EXPECT_TRUE(reading->gripped);
  EXPECT_NEAR(reading->opening_mm, 80, one_count_mm);
}

TEST_F(Modbus, AnOpeningThatIsNoNumberIsRefusedAndSendsNothing) {
  ASSERT_EQ(outcome(driver->connect()), "");
  for (const double opening : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(outcome(driver->start(opening)), "not-finite");
  }
  EXPECT_EQ(gripper.closings(), 0u);
}

TEST_F(Modbus, AnExceptionIsARefusalWithItsCode) {
  ASSERT_EQ(outcome(driver->connect()), "");
  for (const int code : {1, 2, 3, 4, 6}) {
    ASSERT_TRUE(gripper.obey("refuse " + std::to_string(code)));
    const Result<void> started = ask(driver->start(70));
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().symbol, "refused");
    EXPECT_EQ(started.error().subject, to_datum(code));
    EXPECT_NE(started.error().sentence.find("refused registers from 2000 on"), std::string::npos)
        << started.error().sentence;
    EXPECT_EQ(read().error().symbol, "refused");
  }
  ASSERT_TRUE(gripper.obey("refuse 0"));
  EXPECT_TRUE(read());
}

TEST_F(Modbus, RegistersThatItDoesNotHaveAreRefused) {
  const Result<std::vector<std::uint16_t>> beyond = ask(client->read(5000, 2));
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().symbol, "refused");
  EXPECT_EQ(beyond.error().subject, to_datum(2));
}

TEST_F(Modbus, AFaultIsNamedAndMendedOnlyWhenItIsConnectedAnew) {
  ASSERT_EQ(outcome(driver->connect()), "");
  ASSERT_TRUE(gripper.obey("fault 11"));
  ask(nap());
  ask(nap());
  const Result<GripperReading> reading = read();
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "not-in-control");
  EXPECT_EQ(reading.error().sentence, "the gripper has fault 11");
  EXPECT_EQ(reading.error().subject, to_datum(11));
  EXPECT_EQ(outcome(driver->start(70)), "not-in-control");
  EXPECT_EQ(outcome(driver->connect()), "");
  EXPECT_EQ(outcome(driver->start(70)), "");
}

TEST_F(Modbus, OneThatIsSilentFailsInTimeAndKeepsNobodyElseWaiting) {
  ASSERT_EQ(outcome(driver->connect()), "");
  ASSERT_TRUE(gripper.obey("power off"));
  int ticks = 0;
  const Job ticking = executor.spawn([](Executor& clock, int& count) -> Task<void> {
    while (true) {
      co_await sleep(clock, 5ms);
      ++count;
    }
  }(executor, ticks));
  const Time before = executor.now();
  const Result<GripperReading> reading = read();
  EXPECT_LE(executor.now() - before, 2s);
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().symbol, "disconnected");
  EXPECT_EQ(reading.error().sentence.substr(reading.error().sentence.size() - 15), "does not answer");
  EXPECT_GE(ticks, 10) << "the executor's thread waited, too";
  ASSERT_TRUE(gripper.obey("power on"));
  EXPECT_EQ(outcome(driver->connect()), "");
}

// An octet at a time: what is timed is the answer, and not each of them.
TEST_F(Modbus, AnAnswerThatDoesNotComeWholeInTimeIsNone) {
  const auto port = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
  const Job dripping = executor.spawn([](Executor& clock, line::TcpPort& device) -> Task<void> {
    const Time deadline = clock.now() + 20s;
    while (clock.now() < deadline) {
      const Result<void> come = co_await device.open(deadline);
      if (!come) co_return;
      const Result<std::string> asked = co_await device.read(deadline);
      if (!asked) continue;
      const std::string answer = asked->substr(0, 4) + std::string("\0\x09\x09\x03\x06\0\x31\0\0\0\0", 11);
      for (const char octet : answer) {
        co_await sleep(clock, 100ms);
        static_cast<void>(device.write(std::string(1, octet)));
      }
    }
  }(executor, *port));
  ModbusClient slow(executor, "127.0.0.1", port->port(), setup.unit);
  const Result<std::vector<std::uint16_t>> values = ask(slow.read(2000, 3));
  ASSERT_FALSE(values);
  EXPECT_EQ(values.error().symbol, "disconnected");
}

TEST_F(Modbus, ADisconnectionInTheMiddleOfClosingIsOneFailureAndThenItIsFoundAgain) {
  ASSERT_EQ(outcome(driver->connect()), "");
  ASSERT_EQ(outcome(driver->start(60)), "");
  server->hang_up();
  const Result<GripperReading> cut = read();
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().symbol, "disconnected");
  const Result<GripperReading> reading = wait();
  ASSERT_TRUE(reading) << describe(reading.error());
  EXPECT_NEAR(reading->opening_mm, 60, one_count_mm) << "it went on closing meanwhile";
  EXPECT_EQ(gripper.closings(), 1u);
}

TEST_F(Modbus, WhereNobodyListensItIsNotReached) {
  const std::uint16_t port = server->port();
  server.reset();
  const Result<void> connected = ask(driver->connect());
  ASSERT_FALSE(connected);
  EXPECT_EQ(connected.error().symbol, "disconnected");
  EXPECT_NE(connected.error().sentence.find(std::to_string(port)), std::string::npos) << connected.error().sentence;
}

TEST_F(Modbus, ACallThatIsCancelledLeavesNothingBehind) {
  ASSERT_EQ(outcome(driver->connect()), "");
  for (int i = 0; i < 20; ++i) {
    {
      std::optional<Result<GripperReading>> out;
      const Job cut_off = executor.spawn(keep(driver->read(), out));
      ask(client->read(setup.active.number, 1));
    }
    EXPECT_TRUE(read()) << i;
  }
}

// As a device may be whose maker laid it out otherwise: in hundredths of a millimetre, upwards, elsewhere.
forms::GripperSetup laid_out_otherwise() {
  forms::GripperSetup setup;
  setup.target = {7, 0, 16};
  setup.activate = {5, 0, 1};
  setup.go = {6, 15, 1};
  setup.speed_field = {8, 0, 4};
  setup.force_field = {8, 4, 4};
  setup.active = {20, 0, 2};
  setup.object = {21, 0, 2};
  setup.fault = {22, 0, 16};
  setup.opening = {23, 0, 16};
  setup.closed_count = 0;
  setup.open_count = 10'000;
  return setup;
}

class ModbusElsewhere : public Modbus {
 protected:
  ModbusElsewhere() : Modbus(laid_out_otherwise()) {}
};

TEST_F(ModbusElsewhere, ItsRegistersAreWhereTheSetupSays) {
  ASSERT_EQ(outcome(driver->connect()), "");
  ASSERT_EQ(outcome(driver->start(72.5)), "");
  EXPECT_NEAR(wait()->opening_mm, 72.5, 0.01);
}

// A server that answers everything with this.
TEST_F(Modbus, WhatIsNoAnswerIsOneFailure) {
  const auto port = std::move(line::TcpPort::listen(executor, "127.0.0.1", 0).value());
  std::string answer;
  const Job answering = executor.spawn([](Executor& clock, line::TcpPort& device, std::string& said) -> Task<void> {
    while (true) {
      const Time deadline = clock.now() + 10s;
      const Result<void> come = co_await device.open(deadline);
      Result<std::string> heard;
      while (come && heard) {
        heard = co_await device.read(deadline);
        if (heard) static_cast<void>(device.write(said));
      }
    }
  }(executor, *port, answer));
  for (const std::string& said : {std::string("HTTP/1.0 400 Bad Request\r\n\r\n"), std::string(3, '\0'),
                                  std::string("\0\1\0\0\0\3\x09\3\2\0\0", 11), std::string(300, '\xff')}) {
    answer = said;
    ModbusClient odd(executor, "127.0.0.1", port->port(), setup.unit);
    const Result<std::vector<std::uint16_t>> values = ask(odd.read(2000, 3));
    ASSERT_FALSE(values);
    const std::string& symbol = values.error().symbol;
    EXPECT_TRUE(symbol == "bad-reply" || symbol == "disconnected") << symbol << ": " << values.error().sentence;
    EXPECT_FALSE(values.error().sentence.empty());
  }
}

}  // namespace
}  // namespace pizarra::gripper
