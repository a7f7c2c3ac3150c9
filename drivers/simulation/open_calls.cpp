#include "drivers/simulation/open_calls.hpp"

#include <cassert>

namespace pizarra::simulation {

OpenCalls::Call::Call(OpenCalls& calls) : calls_(calls), number_(++calls.last_), answered_(calls.executor_) {
  calls_.waiting_[number_] = this;
}

Task<std::optional<Result<Message>>> OpenCalls::Call::answer(Time deadline) {
  [[maybe_unused]] const bool in_time = co_await answered_.wait(deadline);
  co_return std::move(answer_);
}

OpenCalls::~OpenCalls() { assert(waiting_.empty()); }

void OpenCalls::take(std::uint64_t number, Result<Message> answer) {
  const auto call = waiting_.extract(number);
  if (call.empty()) return;
  call.mapped()->answer_ = std::move(answer);
  call.mapped()->answered_.set();
}

}  // namespace pizarra::simulation
