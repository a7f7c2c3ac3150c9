#pragma once

// Threads for work that would keep another thread too long. They are made when there is work and none is idle, kept for
// the next, and there are `most_threads` at most: more work waits its turn.
//
//   WorkerPool pool;
//   pool.start([] { ... });          // soon, on one of them
//
// Destroying it does what waits still, and joins them. Work must not let an exception out.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pizarra {

class WorkerPool {
 public:
  static constexpr std::size_t most_threads = 64;
  using Work = std::move_only_function<void()>;

  WorkerPool() = default;
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  ~WorkerPool();

  void start(Work work);

 private:
  void serve();

  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<Work> waiting_;
  std::size_t idle_ = 0;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace pizarra
