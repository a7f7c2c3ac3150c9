#include "agents/vision/agent/tracking.hpp"

namespace pizarra::vision {

Result<void> Tracking::add(const LearnedObject& object, std::optional<cv::Point2d> seen_last) {
  return tracker_.add(object, seen_last);
}

void Tracking::keep_only(const std::set<std::string>& names) {
  tracker_.keep_only(names);
  looked_.wake_all();
}

std::vector<TrackSighting> Tracking::look_at(const camera::StereoFrame& frame, const camera::StereoModel& model) {
  StereoSight sight(frame, model);
  std::vector<TrackSighting> sightings = tracker_.update(sight, frame.captured);
  image_ = frame.left;
  is_next_ = false;
  looked_.wake_all();
  return sightings;
}

void Tracking::was_passed_over(const camera::StereoFrame& frame) { is_next_ = is_next_ || frame.left != image_; }

void Tracking::camera_is_gone() {
  is_next_ = false;
  looked_.wake_all();
}

Task<void> Tracking::let_look(Time deadline) {
  bool in_time = true;
  while (in_time) {
    if (empty() || !is_next_) co_return;
    in_time = co_await looked_.wait(deadline);
  }
}

}  // namespace pizarra::vision
