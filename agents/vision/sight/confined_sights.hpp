#pragma once

// One pair of images for several objects, each of which is looked for in an area of its own: what was found out of an
// area serves all objects of it.
//
//   ConfinedSights sights(sight);
//   sights.of(cv::Rect(40, 60, 100, 80)).find(objects, object);
//   sights.of({}).find(objects, other);                         // `sight` itself

#include <deque>

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {

class ConfinedSights {
 public:
  // It outlives this.
  explicit ConfinedSights(StereoSight& whole) : whole_(whole) {}

  StereoSight& of(const std::optional<cv::Rect>& area) {
    if (!area) return whole_;
    for (auto& [known, sight] : confined_) {
      if (known == *area) return sight;
    }
    return confined_.emplace_back(*area, whole_.within(*area)).second;
  }

 private:
  StereoSight& whole_;
  std::deque<std::pair<cv::Rect, StereoSight>> confined_;  // references to them stay
};

}  // namespace pizarra::vision
