#include "blackboard/time/detached_work.hpp"

#include <thread>

namespace pizarra {

void start_detached(Time now, std::function<void(const std::function<Time()>& now)> work) {
  const auto begin = std::chrono::steady_clock::now();
  std::thread([work = std::move(work), now, begin] {
    work([now, begin] { return now + std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - begin); });
  }).detach();
}

}  // namespace pizarra
