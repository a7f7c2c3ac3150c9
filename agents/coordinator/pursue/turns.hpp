#pragma once

// One at a time: what asks while another has its turn waits until that one ends.
//
//   const Turns::Turn turn = co_await turns.next();    // ends with its scope

#include <utility>

#include "blackboard/time/event.hpp"

namespace pizarra {

class Turns {
 public:
  explicit Turns(Executor& executor) : ended_(executor) {}

  class Turn {
   public:
    explicit Turn(Turns& turns) : turns_(&turns) { turns.taken_ = true; }
    Turn(Turn&& other) noexcept : turns_(std::exchange(other.turns_, nullptr)) {}
    Turn& operator=(Turn&&) = delete;
    ~Turn() {
      if (turns_ == nullptr) return;
      turns_->taken_ = false;
      turns_->ended_.wake_one();
    }

   private:
    Turns* turns_;
  };

  Task<Turn> next() {
    while (taken_) co_await ended_.wait();
    co_return Turn(*this);
  }

 private:
  bool taken_ = false;
  WaitList ended_;
};

}  // namespace pizarra
