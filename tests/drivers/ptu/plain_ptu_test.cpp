// The driver on a pan-tilt unit of a few lines that was written from what the command manual and MRPT's driver have,
// and shares no code with the emulated one.

#include <gtest/gtest.h>
#include <map>

#include "blackboard/time/latch.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/ptu/ptu_driver.hpp"
#include "tests/run_task.hpp"

namespace pizarra::ptu {
namespace {

// A PTU-46-17.5 that is at once where it is sent; verbose, and echoing or not.
class PlainUnit : public line::ByteWire {
 public:
  explicit PlainUnit(Executor& executor) : come_(executor) {}
  std::map<std::string, long> values{{"PP", 0}, {"TP", 0}, {"PS", 1000}, {"TS", 1000}};
  std::vector<std::string> obeyed;

  Task<Result<void>> open(Time) override { co_return Result<void>(); }
  void close() override {}
  Result<void> write(std::string_view bytes) override {
    for (const char c : bytes) {
      if (echoes_) said_ += c;
      if (c != ' ' && c != '\r' && c != '\n') {
        command_ += c;
      } else if (!command_.empty()) {
        said_ += answer(std::exchange(command_, {})) + "\r\n";
      }
    }
    come_.wake_all();
    return {};
  }
  Task<Result<std::string>> read(Time deadline) override {
    while (said_.empty()) {
      const bool woken = co_await come_.wait(deadline);
      if (!woken) co_return fail("timeout", "nothing came");
    }
    co_return std::exchange(said_, {});
  }

 private:
  std::string answer(const std::string& command) {
    if (command == "EE" || command == "ED") {
      echoes_ = command == "EE";
      return "*";
    }
    if (command == "V") return "* Pan-Tilt Controller v1.90.00r1(D46), (C)1991-1999 Directed Perception, Inc.";
    if (command == "H" || command == "I" || command == "R") return "*";
    const std::string axis = command.starts_with('P') ? "Pan" : "Tilt";
    const std::string what = command.substr(1);
    const bool pan = axis == "Pan";
    if (what == "R") return "* 185.1428 seconds arc per position";
    if (what == "N") return "* Minimum " + axis + " position is " + (pan ? "-3090" : "-907");
    if (what == "X") return "* Maximum " + axis + " position is " + (pan ? "3090" : "604");
    if (what == "L") return "* Minimum " + axis + " speed is 31 positions/sec";
    if (what == "U") return "* Maximum " + axis + " speed is 2902 positions/sec";
    const std::string key = command.substr(0, 2);
    if (what == "P") return "* Current " + axis + " position is " + std::to_string(values[key]);
    if (what == "O") return "* Target " + axis + " position is " + std::to_string(values[command.substr(0, 1) + "P"]);
    if (what.size() < 2 || !values.contains(key)) return "! Illegal command entered";
    values[key] = std::stol(what.substr(1));
    obeyed.push_back(command);
    return "*";
  }

  bool echoes_ = false;
  std::string command_;
  std::string said_;
  WaitList come_;
};

TEST(PlainPtu, TellsItsRangeAndGoesWhereItIsSent) {
  VirtualExecutor executor;
  PlainUnit unit(executor);
  PtuDriver driver(executor, unit);
  const Result<PanTiltRange> range = run(executor, driver.connect());
  ASSERT_TRUE(range) << describe(range.error());
  constexpr double deg_per_count = 185.1428 / 3600;
  EXPECT_NEAR(range->pan.high_deg, 3090 * deg_per_count, 1e-9);
  EXPECT_NEAR(range->tilt.low_deg, -907 * deg_per_count, 1e-9);
  EXPECT_NEAR(range->tilt.high_deg, 604 * deg_per_count, 1e-9);
  ASSERT_TRUE(run(executor, driver.set_speed(PanTiltAxis::pan, 0.5)));
  ASSERT_TRUE(run(executor, driver.move_to(PanTiltAxis::pan, 10)));
  ASSERT_TRUE(run(executor, driver.move_to(PanTiltAxis::tilt, -20)));
  EXPECT_EQ(unit.obeyed, (std::vector<std::string>{"PS1451", "PP194", "TP-389"}));
  const Result<PanTiltReading> reading = run(executor, driver.read());
  ASSERT_TRUE(reading) << describe(reading.error());
  EXPECT_NEAR(reading->pan_deg, 194 * deg_per_count, 1e-9);
  EXPECT_NEAR(reading->tilt_deg, -389 * deg_per_count, 1e-9);
  EXPECT_FALSE(reading->moving);
  EXPECT_EQ(run(executor, driver.move_to(PanTiltAxis::tilt, 40)).error().symbol, "out-of-range");
}

}  // namespace
}  // namespace pizarra::ptu
