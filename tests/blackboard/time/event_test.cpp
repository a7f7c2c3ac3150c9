#include <gtest/gtest.h>
#include <string>

#include "blackboard/time/latch.hpp"
#include "blackboard/time/virtual_executor.hpp"

namespace pizarra {
namespace {

Task<void> pop_into(Queue<int>& queue, std::string& log, std::optional<Time> deadline) {
  const std::optional<int> item = co_await queue.pop(deadline);
  log += item ? std::to_string(*item) : "late";
  log += ' ';
}

TEST(Queue, HandsItemsToWaitersInOrder) {
  VirtualExecutor executor;
  Queue<int> queue(executor, 8);
  std::string log;
  const Job first = executor.spawn(pop_into(queue, log, {}));
  const Job second = executor.spawn(pop_into(queue, log, {}));
  executor.run_for(1s);
  EXPECT_TRUE(queue.push(1));
  EXPECT_TRUE(queue.push(2));
  executor.run_for(1s);
  EXPECT_EQ(log, "1 2 ");
}

TEST(Queue, RefusesMoreThanItsBound) {
  VirtualExecutor executor;
  Queue<int> queue(executor, 2);
  EXPECT_TRUE(queue.push(1));
  EXPECT_TRUE(queue.push(2));
  EXPECT_FALSE(queue.push(3));
  EXPECT_EQ(queue.size(), 2u);
}

TEST(Queue, PopGivesUpAtItsDeadline) {
  VirtualExecutor executor;
  Queue<int> queue(executor, 8);
  std::string log;
  const Job job = executor.spawn(pop_into(queue, log, executor.now() + 10ms));
  executor.run_for(20ms);
  EXPECT_EQ(log, "late ");
  EXPECT_TRUE(job.done());
}

TEST(Queue, AnItemIsNotLostOnAWaiterCancelledAfterItWasWoken) {
  VirtualExecutor executor;
  Queue<int> queue(executor, 8);
  std::string log;
  Job first = executor.spawn(pop_into(queue, log, {}));
  const Job second = executor.spawn(pop_into(queue, log, {}));
  executor.run_for(1s);
  queue.push(7);
  first = Job();
  executor.run_for(1s);
  EXPECT_EQ(log, "7 ");
  EXPECT_TRUE(second.done());
}

Task<void> wait_for(Event& event, std::string& log, std::optional<Time> deadline) {
  const bool in_time = co_await event.wait(deadline);
  log += in_time ? "set " : "late ";
}

TEST(Event, WakesEveryWaiterOnceSet) {
  VirtualExecutor executor;
  Event event(executor);
  std::string log;
  const Job first = executor.spawn(wait_for(event, log, {}));
  const Job second = executor.spawn(wait_for(event, log, executor.now() + 5ms));
  const Job third = executor.spawn(wait_for(event, log, executor.now() + 60ms));
  executor.run_for(10ms);
  EXPECT_EQ(log, "late ");
  event.set();
  EXPECT_EQ(log, "late ") << "set() must not run its waiters itself";
  executor.run_for(10ms);
  EXPECT_EQ(log, "late set set ");
  const Job late_comer = executor.spawn(wait_for(event, log, {}));
  executor.run_for(10ms);
  EXPECT_EQ(log, "late set set set ");
}

}  // namespace
}  // namespace pizarra
