#include "tests/bench/loop/retry_watch.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"

namespace pizarra::bench {
namespace {

class Slips : public testing::Test {
 protected:
  Slips() {
    take("(gripper robot 60.0)", 1);
    take("(micro-task 7 (close) done)", 1);
  }
  void take(std::string_view fact, double now_s) { watch.take(read_one(fact).value(), now_s); }

  RetryWatch watch;
};

TEST_F(Slips, AreTimedUntilSomethingIsGrippedAgain) {
  take("(gripper robot 41.0)", 2);
  take("(gripper robot 0.0)", 2.25);
  take("(event 5 difference \"...\" ((holding circle)))", 2.5);
  take("(event 6 operation \"operation 1\" (PICK-UP circle))", 4);
  take("(micro-task 7 (close) running)", 8);
  take("(micro-task 7 (close) done)", 8.5);
  ASSERT_EQ(watch.retries().size(), 1U);
  EXPECT_EQ(watch.retries()[0].part_s, (std::array<double, Retry::parts>{0.5, 1.5, 4, 0.5}));
}

TEST_F(Slips, AreNoticedByTheFailureOfAStepToo) {
  take("(gripper robot 0.0)", 2);
  take("(micro-task 8 (raise) failed)", 2.25);
  take("(event 5 operation \"...\" (fail slipped \"...\" ()))", 2.5);
  take("(micro-task 7 (close) running)", 8);
  take("(micro-task 7 (close) done)", 8.5);
  ASSERT_EQ(watch.retries().size(), 1U);
  EXPECT_EQ(watch.retries()[0].part_s, (std::array<double, Retry::parts>{0.25, 5.75, 0, 0.5}));
}

TEST_F(Slips, AreNotWhatTheFingersLetGo) {
  take("(micro-task 4 (release) running)", 2);
  take("(gripper robot 80.0)", 2.5);
  take("(gripper robot 0.0)", 3);
  take("(micro-task 7 (close) done)", 4);
  EXPECT_TRUE(watch.retries().empty());
}

}  // namespace
}  // namespace pizarra::bench
