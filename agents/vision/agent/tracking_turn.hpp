#pragma once

// Which frames are the tracking's. A finding takes frames from it, but only every second one.
//
//   TrackingTurn turn(executor);
//   if (turn.is_due(frame)) ...                           // the tracker looks at it
//   turn.looked_at(frame);
//   turn.was_passed_over(frame);                          // a finding has looked at it
//   co_await turn.let_look(deadline);                     // before the next finding looks at one

#include "blackboard/time/latch.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

class TrackingTurn {
 public:
  // The executor outlives it, and it outlives whoever waits.
  explicit TrackingTurn(Executor& executor) : changed_(executor) {}

  // Frames that were captured before are not the tracking's from here on.
  void look_only_after(Time asked) { asked_ = asked; }
  bool is_due(const camera::StereoFrame& frame) const { return frame.captured > asked_; }
  void looked_at(const camera::StereoFrame& frame);
  void was_passed_over(const camera::StereoFrame& frame) { is_next_ = is_next_ || frame.left != image_; }
  // No frame comes, or nothing is tracked: nobody waits for the tracking to look.
  void let_go();
  // Waits until a frame was looked at since one was passed over, or until then.
  Task<void> let_look(Time deadline);

 private:
  WaitList changed_;
  Time asked_ = {};                     // for the object that was added last
  std::shared_ptr<const Image> image_;  // the left one looked at last, kept since the tracker may look back at it
  bool is_next_ = false;                // since a frame was passed over
};

}  // namespace pizarra::vision
