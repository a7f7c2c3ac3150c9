#include "blackboard/time/together.hpp"

#include <gtest/gtest.h>
#include <string>

#include "blackboard/time/virtual_executor.hpp"

namespace pizarra {
namespace {

struct Log {
  std::string begun;
  std::size_t running = 0;
  std::size_t most_running = 0;
};

Task<void> take_seconds(Executor& executor, int seconds, Log* log) {
  log->begun += std::to_string(seconds);
  log->most_running = std::max(log->most_running, ++log->running);
  co_await sleep(executor, seconds * 1s);
  --log->running;
}

std::vector<Task<void>> tasks_of(Executor& executor, std::initializer_list<int> seconds, Log* log) {
  std::vector<Task<void>> tasks;
  for (const int each : seconds) tasks.push_back(take_seconds(executor, each, log));
  return tasks;
}

TEST(RunTogether, BeginsTheNextWhenOneEnds) {
  VirtualExecutor executor;
  Log log;
  const Job all = executor.spawn(run_together(executor, tasks_of(executor, {5, 1, 2, 3}, &log), 2));
  executor.run_for(5900ms);
  EXPECT_EQ(log.begun, "5123");
  EXPECT_EQ(log.most_running, 2U);
  EXPECT_FALSE(all.done());
  executor.run_for(200ms);
  EXPECT_TRUE(all.done()) << "1, 2 and 3 s one after another, beside the 5 s";
}

TEST(RunTogether, IsDoneAtOnceWithNothingToDo) {
  VirtualExecutor executor;
  const Job none = executor.spawn(run_together(executor, {}, 2));
  executor.run_for(1ms);
  EXPECT_TRUE(none.done());
}

TEST(RunTogether, IsCancelledWithAllThatRuns) {
  VirtualExecutor executor;
  Log log;
  {
    const Job all = executor.spawn(run_together(executor, tasks_of(executor, {1, 2, 3}, &log), 2));
    executor.run_for(500ms);
  }
  executor.run_for(10s);
  EXPECT_EQ(log.begun, "12");
  EXPECT_EQ(log.running, 2U) << "none of them ends";
}

}  // namespace
}  // namespace pizarra
