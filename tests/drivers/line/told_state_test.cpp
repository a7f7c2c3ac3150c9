#include "drivers/line/told_state.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/virtual_executor.hpp"
#include "tests/drivers/line/wire_pair.hpp"
#include "tests/run_task.hpp"

namespace pizarra::line {
namespace {

// A device that tells numbers, a line each; "-" is none.
class Told : public testing::Test {
 protected:
  void SetUp() override {
    const Time soon = executor.now() + 1s;
    ASSERT_TRUE(run(executor, dialogue.open(soon)));
    ASSERT_TRUE(run(executor, line.far.open(soon)));
  }
  // Whether it is known soon.
  Result<void> listen() {
    const ToldState::Hear hear = [this](const std::string& message) -> Result<bool> {
      if (message == "-") return fail("bad-reply", "the device says what is no number");
      if (message.starts_with('?')) return false;
      value = std::stoi(message);
      return true;
    };
    return run(executor, told.listen(hear, 10ms));
  }
  VirtualExecutor executor;
  WirePair line{executor};
  Dialogue dialogue{executor, line.near, frame_of_line, "the device"};
  ToldState told{dialogue, 200ms};
  int value = 0;
};

TEST_F(Told, IsKnownForAsLongAsItIsFresh) {
  EXPECT_EQ(listen().error().sentence, "the device does not tell its state");
  EXPECT_FALSE(told.known());
  ASSERT_TRUE(line.far.write("7\n"));
  executor.run_for(1ms);
  EXPECT_TRUE(told.known());
  EXPECT_EQ(value, 7);
  executor.run_for(150ms);
  EXPECT_TRUE(told.known());
  ASSERT_TRUE(line.far.write("? something else\n"));
  executor.run_for(100ms);
  EXPECT_FALSE(told.known());
}

TEST_F(Told, WhatIsNotSoundIsPassedOverAndSaysWhyUntilASoundOneComes) {
  ASSERT_TRUE(line.far.write("7\n-\n"));
  ASSERT_TRUE(listen());
  EXPECT_TRUE(told.known());
  EXPECT_EQ(value, 7);
  executor.run_for(300ms);
  EXPECT_FALSE(told.known());
  EXPECT_EQ(told.unknown().error().sentence, "the device says what is no number");
  ASSERT_TRUE(line.far.write("8\n"));
  executor.run_for(300ms);
  EXPECT_EQ(told.unknown().error().sentence, "the device does not tell its state");
}

TEST_F(Told, ALineThatFailsLeavesNothingKnownAtOnce) {
  ASSERT_TRUE(line.far.write("7\n"));
  ASSERT_TRUE(listen());
  line.cut(true);
  executor.run_for(1ms);
  EXPECT_FALSE(told.known());
  EXPECT_EQ(told.unknown().error().symbol, "disconnected");
}

TEST_F(Told, WhoWaitsSeesItComeTrueWithTheMessageAndGivesUpInTime) {
  EXPECT_FALSE(listen());
  const Time begin = executor.now();
  std::function<bool()> is_nine = [this] { return value == 9; };
  Task<bool> nine = told.until(is_nine, 100ms);
  EXPECT_FALSE(run(executor, std::move(nine)));
  EXPECT_EQ(executor.now() - begin, 100ms);
  ASSERT_TRUE(line.far.write("8\n9\n"));
  EXPECT_TRUE(run(executor, told.until(is_nine, 100ms)));
  EXPECT_EQ(executor.now() - begin, 100ms);
}

TEST_F(Told, AQuestionTakesTheAnswerThatFitsAndTheNextWaitsForItsTurn) {
  const Dialogue::Fits begins_with_b = [](const std::string& message) { return message.starts_with('b'); };
  Result<std::string> first, second;
  const auto ask = [&](std::string question, Dialogue::Fits fits, Result<std::string>& answer) -> Task<void> {
    answer = co_await dialogue.ask(std::move(question), std::move(fits));
  };
  const Job one = executor.spawn(ask("one\n", begins_with_b, first));
  const Job two = executor.spawn(ask("two\n", begins_with_b, second));
  executor.run_for(1ms);
  EXPECT_EQ(line.near.written, "one\n");
  ASSERT_TRUE(line.far.write("a\nb1\n"));
  executor.run_for(1ms);
  EXPECT_EQ(first.value(), "b1");
  EXPECT_EQ(line.near.written, "one\ntwo\n");
  executor.run_for(2s);
  EXPECT_EQ(second.error().symbol, "disconnected");
  EXPECT_EQ(second.error().sentence.find("the device did not answer"), 0u) << second.error().sentence;
}

}  // namespace
}  // namespace pizarra::line
