#include "blackboard/time/executor.hpp"

#include <exception>

namespace pizarra {

struct Job::State {
  Task<void> task;
  bool done = false;
};

namespace {

Task<void> run_to_end(Task<void> task, bool& done) {
  try {
    co_await task;
  } catch (...) {
    std::terminate();
  }
  done = true;
}

}  // namespace

Job::Job() = default;
Job::Job(Task<void> task) : state_(std::make_shared<State>()) {
  state_->task = run_to_end(std::move(task), state_->done);
}
Job::Job(Job&&) noexcept = default;
Job& Job::operator=(Job&&) noexcept = default;
Job::~Job() = default;

bool Job::done() const { return state_ == nullptr || state_->done; }

Job Executor::spawn(Task<void> task) {
  Job job(std::move(task));
  post([state = std::weak_ptr(job.state_)] {
    // The job may have been cancelled before it began. Holding it here would destroy it too late.
    if (auto alive = state.lock()) {
      const auto handle = alive->task.handle();
      alive.reset();
      handle.resume();
    }
  });
  return job;
}

}  // namespace pizarra
