#include "blackboard/time/turns.hpp"

namespace pizarra {

Task<Turns::Turn> Turns::take() {
  while (taken_) co_await waiting_.wait();
  co_return Turn(*this);
}

}  // namespace pizarra
