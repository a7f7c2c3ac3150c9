#include "blackboard/time/real_executor.hpp"

#include <algorithm>
#include <poll.h>
#include <sys/eventfd.h>
#include <system_error>
#include <unistd.h>

#include "blackboard/time/latch.hpp"

namespace pizarra {

struct RealExecutor::Offloaded {
  explicit Offloaded(Executor& executor) : finished(executor) {}
  std::function<void(const std::function<bool()>&)> work;
  std::atomic<bool> cancelled = false;
  Event finished;
};

Time RealExecutor::wall_clock() { return std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now()); }

RealExecutor::RealExecutor(Time begin)
    : steady_start_(std::chrono::steady_clock::now()), start_(begin), wake_up_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (wake_up_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

RealExecutor::~RealExecutor() {
  ending_ = true;
  workers_.reset();
  close(wake_up_);
}

Time RealExecutor::now() const {
  return start_ + std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - steady_start_);
}

void RealExecutor::post(Callback callback) {
  {
    const std::scoped_lock lock(mutex_);
    posted_.push_back(std::move(callback));
  }
  if (runner_ == std::this_thread::get_id()) return;
  // The counter cannot overflow and a full one wakes as well, so the result says nothing.
  [[maybe_unused]] const auto written = eventfd_write(wake_up_, 1);
}

Executor::TimerId RealExecutor::call_at(Time when, Callback callback) {
  const TimerId timer = next_timer_++;
  if (when <= now()) {
    due_.emplace_back(timer, std::move(callback));
    return timer;
  }
  timers_.emplace(std::pair(when, timer), std::move(callback));
  times_.emplace(timer, when);
  return timer;
}

void RealExecutor::cancel(TimerId timer) {
  if (const auto due = find_due(timer); due != due_.end()) {
    const Callback cancelled = std::exchange(due->second, nullptr);
    return;
  }
  const auto found = times_.find(timer);
  if (found == times_.end()) return;
  // The callback is destroyed last, because what it owns may cancel timers in turn.
  const auto node = timers_.extract(std::pair(found->second, timer));
  times_.erase(found);
}

void RealExecutor::watch_readable(int file, std::function<void()> callback) {
  files_[file] = std::make_shared<std::function<void()>>(std::move(callback));
}

void RealExecutor::unwatch_readable(int file) { files_.erase(file); }

Task<void> RealExecutor::offload(std::function<void(const std::function<bool()>&)> work, Duration) {
  struct Cancel {
    std::shared_ptr<Offloaded> offloaded;
    ~Cancel() { offloaded->cancelled = true; }
  };
  const Cancel running{std::make_shared<Offloaded>(*this)};
  running.offloaded->work = std::move(work);
  workers_->start([this, offloaded = running.offloaded] {
    offloaded->work([this, &offloaded] { return offloaded->cancelled || ending_; });
    post([offloaded] { offloaded->finished.set(); });
  });
  co_await running.offloaded->finished.wait();
}

bool RealExecutor::run_posted(const std::function<bool()>& finished) {
  std::deque<Callback> batch;
  {
    const std::scoped_lock lock(mutex_);
    batch.swap(posted_);
  }
  while (!batch.empty()) {
    if (stopped_ || finished()) {
      const std::scoped_lock lock(mutex_);
      posted_.insert(posted_.begin(), std::make_move_iterator(batch.begin()), std::make_move_iterator(batch.end()));
      return false;
    }
    Callback callback = std::move(batch.front());
    batch.pop_front();
    callback();
  }
  return true;
}

bool RealExecutor::run_timers(const std::function<bool()>& finished) {
  const Time due = now();
  while (!timers_.empty() && timers_.begin()->first.first <= due) {
    if (stopped_ || finished()) return false;
    auto node = timers_.extract(timers_.begin());
    times_.erase(node.key().second);
    node.mapped()();
  }
  return true;
}

RealExecutor::Due::iterator RealExecutor::find_due(TimerId timer) {
  const auto found = std::ranges::lower_bound(due_, timer, {}, &Due::value_type::first);
  return found != due_.end() && found->first == timer ? found : due_.end();
}

// Timers that they make due wait for the next round, so that files have their turn.
bool RealExecutor::run_due(const std::function<bool()>& finished) {
  for (std::size_t left = due_.size(); left > 0; --left) {
    if (stopped_ || finished()) return false;
    Callback callback = std::move(due_.front().second);
    due_.pop_front();
    if (callback) callback();
  }
  return true;
}

bool RealExecutor::has_work() {
  if (!due_.empty()) return true;
  const std::scoped_lock lock(mutex_);
  return !posted_.empty();
}

void RealExecutor::drain_wake_up() {
  eventfd_t count;
  // Nothing to read is fine: somebody drained it before.
  [[maybe_unused]] const auto drained = eventfd_read(wake_up_, &count);
}

void RealExecutor::poll_files() {
  std::vector<pollfd> polled{{wake_up_, POLLIN, 0}};
  for (const auto& [file, callback] : files_) polled.push_back({file, POLLIN, 0});
  timespec wait{};
  timespec* timeout = nullptr;
  if (has_work()) {
    timeout = &wait;
  } else if (!timers_.empty()) {
    const auto left = std::max(timers_.begin()->first.first - now(), Duration::zero());
    wait = {.tv_sec = left.count() / 1'000'000, .tv_nsec = left.count() % 1'000'000 * 1000};
    timeout = &wait;
  }
  if (ppoll(polled.data(), polled.size(), timeout, nullptr) <= 0) return;
  if (polled[0].revents != 0) drain_wake_up();
  for (std::size_t i = 1; i < polled.size(); ++i) {
    if (polled[i].revents == 0) continue;
    const auto found = files_.find(polled[i].fd);
    if (found == files_.end()) continue;
    // Held, because the callback may unwatch itself.
    const auto callback = found->second;
    (*callback)();
  }
}

void RealExecutor::run_until(std::function<bool()> finished) {
  constexpr int rounds_at_most = 8;
  runner_ = std::this_thread::get_id();
  while (!stopped_ && !finished()) {
    if (!run_posted(finished) || !run_timers(finished) || !run_due(finished)) break;
    if (stopped_ || finished()) break;
    // Looking at the files costs more than most callbacks do.
    if (has_work() && ++rounds_without_files_ < rounds_at_most) continue;
    rounds_without_files_ = 0;
    poll_files();
  }
  runner_ = std::thread::id();
  stopped_ = false;
}

void RealExecutor::stop() {
  stopped_ = true;
  [[maybe_unused]] const auto written = eventfd_write(wake_up_, 1);
}

}  // namespace pizarra
