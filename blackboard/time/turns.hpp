#pragma once

// One at a time: those who come while somebody has the turn wait for theirs.
//
//   const Turns::Turn turn = co_await turns.take();      // until it goes

#include <utility>

#include "blackboard/time/latch.hpp"

namespace pizarra {

class Turns {
 public:
  class [[nodiscard]] Turn {
   public:
    explicit Turn(Turns& turns) : turns_(&turns) { turns_->taken_ = true; }
    Turn(Turn&& other) noexcept : turns_(std::exchange(other.turns_, nullptr)) {}
    Turn& operator=(Turn&&) = delete;
    ~Turn() {
      if (turns_ == nullptr) return;
      turns_->taken_ = false;
      turns_->waiting_.wake_one();
    }

   private:
    Turns* turns_;
  };

  explicit Turns(Executor& executor) : waiting_(executor) {}
  Task<Turn> take();

 private:
  bool taken_ = false;
  WaitList waiting_;
};

}  // namespace pizarra
