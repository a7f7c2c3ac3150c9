#include "agents/vision/agent/tracking_turn.hpp"

namespace pizarra::vision {

void TrackingTurn::looked_at(const camera::StereoFrame& frame) {
  image_ = frame.left;
  let_go();
}

void TrackingTurn::let_go() {
  is_next_ = false;
  changed_.wake_all();
}

Task<void> TrackingTurn::let_look(Time deadline) {
  bool in_time = true;
  while (in_time) {
    if (!is_next_) co_return;
    in_time = co_await changed_.wait(deadline);
  }
}

}  // namespace pizarra::vision
