#pragma once

// Runs a task to its end, for tests that are no tasks themselves.
//
//   const Result<double> pan = run(executor, driver.pan_deg());

#include <optional>

#include "blackboard/time/executor.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra {

template <class T>
Task<void> keep(Task<T> task, std::optional<T>& out) {
  T value = co_await task;
  out.emplace(std::move(value));
}

template <class T>
T run(Executor& executor, Task<T> task) {
  std::optional<T> out;
  const Job job = executor.spawn(keep(std::move(task), out));
  executor.run_until([&] { return out.has_value(); });
  return std::move(*out);
}

}  // namespace pizarra
