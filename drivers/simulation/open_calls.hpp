#pragma once

// The calls of a device link that wait for their answers, each by its number. An answer is taken once, by the call that
// it is for: one that comes again, or after its call's deadline, is nobody's.
//
//   OpenCalls calls(executor);
//   OpenCalls::Call call(calls);                                       // call.number() goes along with the request
//   calls.take(number, std::move(message));                            // whoever reads the wire
//   std::optional<Result<Message>> answer = co_await call.answer(deadline);
//
// It outlives its calls.

#include <map>
#include <optional>

#include "blackboard/time/latch.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class OpenCalls {
 public:
  class Call {
   public:
    explicit Call(OpenCalls& calls);
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    ~Call() { calls_.waiting_.erase(number_); }
    std::uint64_t number() const { return number_; }
    // Empty where none came in time.
    Task<std::optional<Result<Message>>> answer(Time deadline);

   private:
    friend class OpenCalls;
    OpenCalls& calls_;
    const std::uint64_t number_;
    Event answered_;
    std::optional<Result<Message>> answer_;
  };

  explicit OpenCalls(Executor& executor) : executor_(executor) {}
  OpenCalls(const OpenCalls&) = delete;
  OpenCalls& operator=(const OpenCalls&) = delete;
  ~OpenCalls();

  std::size_t size() const { return waiting_.size(); }
  void take(std::uint64_t number, Result<Message> answer);

 private:
  Executor& executor_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, Call*> waiting_;
};

}  // namespace pizarra::simulation
