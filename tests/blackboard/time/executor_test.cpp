#include "blackboard/time/executor.hpp"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <unistd.h>

#include "blackboard/time/latch.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "blackboard/time/worker_pool.hpp"

namespace pizarra {
namespace {

// What both kinds of time promise.
template <class T>
class AnyExecutor : public testing::Test {
 protected:
  T executor;
};
using Kinds = testing::Types<VirtualExecutor, RealExecutor>;
TYPED_TEST_SUITE(AnyExecutor, Kinds);

TYPED_TEST(AnyExecutor, RunsPostedCallbacksInOrder) {
  std::string seen;
  for (const char c : {'a', 'b', 'c'}) this->executor.post([&seen, c] { seen += c; });
  this->executor.run_until([&] { return seen.size() == 3; });
  EXPECT_EQ(seen, "abc");
}

TYPED_TEST(AnyExecutor, RunsTimersByTimeAndThenByRegistration) {
  std::string seen;
  const Time start = this->executor.now();
  this->executor.call_at(start + 3ms, [&] { seen += 'd'; });
  this->executor.call_at(start + 1ms, [&] { seen += 'a'; });
  this->executor.call_at(start + 2ms, [&] { seen += 'b'; });
  this->executor.call_at(start + 2ms, [&] { seen += 'c'; });
  this->executor.run_until([&] { return seen.size() == 4; });
  EXPECT_EQ(seen, "abcd");
}

TYPED_TEST(AnyExecutor, NeverRunsATimerEarlyNorACancelledOne) {
  const Time start = this->executor.now();
  bool cancelled_ran = false;
  Time ran{};
  const auto timer = this->executor.call_at(start + 1ms, [&] { cancelled_ran = true; });
  this->executor.call_at(start + 5ms, [&] { ran = this->executor.now(); });
  this->executor.cancel(timer);
  this->executor.cancel(timer);
  this->executor.run_until([&] { return ran != Time{}; });
  EXPECT_GE(ran, start + 5ms);
  EXPECT_FALSE(cancelled_ran);
}

TYPED_TEST(AnyExecutor, StopEndsTheRunEvenWhenItCameFirst) {
  this->executor.stop();
  this->executor.post([] { FAIL() << "ran after stop"; });
  this->executor.run_until([] { return false; });
}

Task<int> twice(Executor& executor, int value) {
  co_await sleep(executor, 1ms);
  co_return 2 * value;
}

Task<void> sum(Executor& executor, int& out) {
  const int a = co_await twice(executor, 3);
  const int b = co_await twice(executor, a);
  out = b;
}

TYPED_TEST(AnyExecutor, TasksAwaitTasks) {
  int out = 0;
  const Job job = this->executor.spawn(sum(this->executor, out));
  this->executor.run_until([&] { return job.done(); });
  EXPECT_EQ(out, 12);
}

struct Witness {
  std::string& log;
  const char* name;
  ~Witness() { log += name; }
};

Task<void> sleep_long(Executor& executor, std::string& log) {
  const Witness witness{log, "inner "};
  co_await sleep(executor, 3600s);
  log += "woke ";
}

Task<void> wait_for_sleeper(Executor& executor, std::string& log) {
  const Witness witness{log, "outer "};
  co_await sleep_long(executor, log);
}

TYPED_TEST(AnyExecutor, DestroyingAJobCancelsTheWholeTaskFromTheInside) {
  std::string log;
  bool begun = false;
  {
    const Job job = this->executor.spawn(wait_for_sleeper(this->executor, log));
    this->executor.post([&] { begun = true; });
    this->executor.run_until([&] { return begun; });
    EXPECT_EQ(log, "");
  }
  EXPECT_EQ(log, "inner outer ");
}

TYPED_TEST(AnyExecutor, AJobDestroyedBeforeItBeganNeverRuns) {
  int out = 0;
  { const Job job = this->executor.spawn(sum(this->executor, out)); }
  bool after = false;
  this->executor.post([&] { after = true; });
  this->executor.run_until([&] { return after; });
  EXPECT_EQ(out, 0);
}

Task<void> compute(Executor& executor, std::shared_ptr<int> result, bool& finished) {
  const std::function<void(const std::function<bool()>&)> work = [result](const std::function<bool()>&) {
    *result = 42;
  };
  co_await executor.offload(work, 20ms);
  finished = true;
}

TYPED_TEST(AnyExecutor, OffloadedWorkFinishesBeforeItsTaskGoesOn) {
  auto result = std::make_shared<int>(0);
  bool finished = false;
  const Job job = this->executor.spawn(compute(this->executor, result, finished));
  this->executor.run_until([&] { return job.done(); });
  EXPECT_TRUE(finished);
  EXPECT_EQ(*result, 42);
}

TEST(VirtualExecutor, OffloadCostsItsVirtualTimeAndSleepNothingReal) {
  VirtualExecutor executor;
  auto result = std::make_shared<int>(0);
  bool finished = false;
  const Job job = executor.spawn(compute(executor, result, finished));
  executor.run_until([&] { return job.done(); });
  EXPECT_EQ(executor.now(), Time{} + 20ms);
  executor.run_for(3600s);
  EXPECT_EQ(executor.now(), Time{} + 3600s + 20ms);
}

Task<void> spin(Executor& executor, std::shared_ptr<std::atomic<bool>> noticed) {
  const std::function<void(const std::function<bool()>&)> work = [noticed](const std::function<bool()>& cancelled) {
    while (!cancelled()) std::this_thread::yield();
    *noticed = true;
  };
  co_await executor.offload(work, 0ms);
}

TEST(RealExecutor, DestroyingATaskTellsItsOffloadedWork) {
  auto noticed = std::make_shared<std::atomic<bool>>(false);
  {
    RealExecutor executor;
    bool begun = false;
    const Job job = executor.spawn(spin(executor, noticed));
    executor.post([&] { begun = true; });
    executor.run_until([&] { return begun; });
  }
  EXPECT_TRUE(*noticed);
}

Task<void> note_threads(Executor& executor, std::shared_ptr<std::vector<std::thread::id>> threads, int times) {
  const std::function<void(const std::function<bool()>&)> work = [threads](const std::function<bool()>&) {
    threads->push_back(std::this_thread::get_id());
  };
  for (int i = 0; i < times; ++i) co_await executor.offload(work, 0ms);
}

TEST(RealExecutor, OffloadedWorkAfterWorkNeedsNoNewThreadEachTime) {
  constexpr int times = 200;
  RealExecutor executor;
  auto threads = std::make_shared<std::vector<std::thread::id>>();
  const Job job = executor.spawn(note_threads(executor, threads, times));
  executor.run_until([&] { return job.done(); });
  ASSERT_EQ(threads->size(), times);
  // One may still be on its way back when the next work comes.
  EXPECT_LT(std::set<std::thread::id>(threads->begin(), threads->end()).size(), times / 10);
}

struct Crowd {
  std::size_t offloaded = 0;
  std::atomic<std::size_t> begun = 0;
  std::atomic<std::size_t> inside = 0;
  std::atomic<std::size_t> most_inside = 0;
  std::atomic<bool> may_leave = false;
};

Task<void> join(Executor& executor, std::shared_ptr<Crowd> crowd) {
  const std::function<void(const std::function<bool()>&)> work = [&executor,
                                                                  crowd](const std::function<bool()>& cancelled) {
    const std::size_t inside = ++crowd->inside;
    std::size_t most = crowd->most_inside;
    while (most < inside && !crowd->most_inside.compare_exchange_weak(most, inside)) continue;
    ++crowd->begun;
    executor.post([] {});  // somebody may wait for it
    while (!crowd->may_leave && !cancelled()) std::this_thread::yield();
    --crowd->inside;
  };
  ++crowd->offloaded;
  co_await executor.offload(work, 0ms);
}

TEST(RealExecutor, MoreOffloadedWorkThanItHasThreadsWaitsItsTurn) {
  constexpr std::size_t works = WorkerPool::most_threads + 8;
  auto crowd = std::make_shared<Crowd>();
  RealExecutor executor;
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < works; ++i) jobs.push_back(executor.spawn(join(executor, crowd)));
  executor.run_until([&] { return crowd->begun == WorkerPool::most_threads; });
  crowd->may_leave = true;
  executor.run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
  EXPECT_EQ(crowd->begun, works);
  EXPECT_EQ(crowd->most_inside, WorkerPool::most_threads);
}

TEST(RealExecutor, OffloadedWorkWhoseTurnNeverCameLearnsOfTheEndToo) {
  constexpr std::size_t works = WorkerPool::most_threads + 8;
  auto crowd = std::make_shared<Crowd>();
  {
    RealExecutor executor;
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < works; ++i) jobs.push_back(executor.spawn(join(executor, crowd)));
    executor.run_until([&] { return crowd->begun == WorkerPool::most_threads && crowd->offloaded == works; });
  }
  EXPECT_EQ(crowd->begun, works);
  EXPECT_EQ(crowd->inside, 0);
}

TEST(RealExecutor, OtherThreadsWakeItByPosting) {
  RealExecutor executor;
  bool woken = false;
  std::thread thread([&] { executor.post([&] { woken = true; }); });
  executor.run_until([&] { return woken; });
  thread.join();
}

TEST(RealExecutor, CallsBackForReadableFilesUntilUnwatched) {
  RealExecutor executor;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  int calls = 0;
  executor.watch_readable(ends[0], [&] {
    if (++calls == 2) executor.unwatch_readable(ends[0]);
  });
  ASSERT_EQ(::write(ends[1], "x", 1), 1);
  executor.run_until([&] { return calls == 2; });
  bool later = false;
  executor.call_at(executor.now() + 5ms, [&] { later = true; });
  executor.run_until([&] { return later; });
  EXPECT_EQ(calls, 2);
  close(ends[0]);
  close(ends[1]);
}

Task<void> throw_up() {
  throw std::runtime_error("a bug");
  co_return;
}

TEST(ExecutorDeathTest, AnExceptionThatLeavesAJobEndsTheProgram) {
  EXPECT_DEATH(
      {
        VirtualExecutor executor;
        const Job job = executor.spawn(throw_up());
        executor.run_until([] { return false; });
      },
      "");
}

}  // namespace
}  // namespace pizarra
