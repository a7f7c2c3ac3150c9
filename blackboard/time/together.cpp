#include "blackboard/time/together.hpp"

#include <algorithm>

#include "blackboard/time/latch.hpp"

namespace pizarra {

namespace {

struct Lanes {
  std::vector<Task<void>> tasks;
  std::size_t next = 0;
  std::size_t open = 0;
  Event done;
};

Task<void> run_lane(Lanes* lanes) {
  while (lanes->next < lanes->tasks.size()) {
    Task<void> task = std::move(lanes->tasks[lanes->next++]);
    co_await task;
  }
  if (--lanes->open == 0) lanes->done.set();
}

}  // namespace

Task<void> run_together(Executor& executor, std::vector<Task<void>> tasks, std::size_t at_once) {
  const std::size_t open = std::min(at_once, tasks.size());
  if (open == 0) co_return;
  Lanes lanes{.tasks = std::move(tasks), .open = open, .done = Event(executor)};
  std::vector<Job> running;
  while (running.size() < open) running.push_back(executor.spawn(run_lane(&lanes)));
  co_await lanes.done.wait();
}

}  // namespace pizarra
