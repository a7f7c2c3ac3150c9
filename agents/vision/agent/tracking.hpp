#pragma once

// The tracked objects, looked at in each frame that is the tracking's. A finding takes frames from it, but only every
// second one.
//
//   Tracking tracking(executor, objects);
//   Result<void> added = tracking.add(*objects.find("circle"), seen_last, asked);
//   if (tracking.is_due(frame)) sightings = tracking.look_at(frame, model);
//   tracking.was_passed_over(frame);                      // a finding has looked at it
//   co_await tracking.let_look(deadline);                 // before the next finding looks at one

#include "agents/vision/sight/mark_tracker.hpp"
#include "blackboard/time/latch.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

class Tracking {
 public:
  // Both outlive it, and it outlives whoever waits.
  Tracking(Executor& executor, const LearnedObjects& objects) : looked_(executor), tracker_(objects) {}

  bool empty() const { return tracker_.empty(); }
  // Of several that are alike it begins with the one nearest to `seen_last`. Failure `full`.
  Result<void> add(const LearnedObject& object, std::optional<cv::Point2d> seen_last);
  // Frames that were captured before are not looked at from here on.
  void look_only_after(Time asked) { asked_ = asked; }
  void keep_only(const std::set<std::string>& names);
  void rename(const Renames& renames) { tracker_.rename(renames); }

  bool is_due(const camera::StereoFrame& frame) const { return !empty() && frame.captured > asked_; }
  std::vector<TrackSighting> look_at(const camera::StereoFrame& frame, const camera::StereoModel& model);
  // No image came until now.
  std::vector<TrackSighting> miss_all(Time now) { return tracker_.miss_all(now); }

  void was_passed_over(const camera::StereoFrame& frame);
  // No frame comes: nobody waits for this to look.
  void camera_is_gone();
  // Waits until it has looked at a frame since one was passed over, or until then.
  Task<void> let_look(Time deadline);

 private:
  WaitList looked_;
  MarkTracker tracker_;
  Time asked_ = {};                     // for the object that was added last
  std::shared_ptr<const Image> image_;  // the left one, at which the tracker may look back
  bool is_next_ = false;                // since a frame was passed over
};

}  // namespace pizarra::vision
