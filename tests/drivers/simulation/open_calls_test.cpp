// Which call takes which answer.

#include "drivers/simulation/open_calls.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/virtual_executor.hpp"
#include "tests/run_task.hpp"

namespace pizarra::simulation {
namespace {

class CallsThatWait : public testing::Test {
 protected:
  std::optional<Result<Message>> answer_of(OpenCalls::Call& call) {
    return run(executor_, call.answer(executor_.now() + 100ms));
  }
  static Message says(const char* word) { return {list(Datum::symbol(word))}; }

  VirtualExecutor executor_;
  OpenCalls calls_{executor_};
};

TEST_F(CallsThatWait, TakeTheirOwnAnswersInAnyOrder) {
  OpenCalls::Call one(calls_);
  OpenCalls::Call other(calls_);
  calls_.take(other.number(), says("other"));
  calls_.take(one.number(), fail("busy", "it has much to do"));
  EXPECT_EQ((*answer_of(one)).error().symbol, "busy");
  EXPECT_EQ((*answer_of(other))->head, list("other"_sym));
}

// As of an arm that acknowledges twice: the second time is no word about the next command.
TEST_F(CallsThatWait, TakeNoAnswerThatAnotherHasTakenBefore) {
  std::uint64_t first = 0;
  {
    OpenCalls::Call call(calls_);
    first = call.number();
    calls_.take(first, says("done"));
    calls_.take(first, fail("stopped", "it came once more, and says something else"));
    EXPECT_EQ((*answer_of(call))->head, list("done"_sym));
  }
  OpenCalls::Call next(calls_);
  calls_.take(first, says("done"));
  EXPECT_FALSE(answer_of(next));
}

TEST_F(CallsThatWait, LeaveAnAnswerThatComesTooLateToNobody) {
  std::uint64_t late = 0;
  {
    OpenCalls::Call call(calls_);
    late = call.number();
    EXPECT_FALSE(answer_of(call));
  }
  EXPECT_EQ(calls_.size(), 0U);
  calls_.take(late, says("done"));
  EXPECT_EQ(calls_.size(), 0U);
}

}  // namespace
}  // namespace pizarra::simulation
