#pragma once

// Where an object is in a pair of images, how sure that is, how far away it is and where else marks are that it may be
// as well; or why it is nowhere. Of several that are as like it, it is the one nearest to where it was found last.
//
//   MarkFinder finder(objects);
//   Result<FoundMark> found = finder.find(sight, *objects.find("circle"), now);
//   finder.place_of("circle");                    // where it was found last, in whatever image

#include <map>

#include "agents/vision/objects/renames.hpp"
#include "agents/vision/sight/mark_pose.hpp"
#include "agents/vision/sight/seen_range.hpp"
#include "blackboard/time/clock.hpp"

namespace pizarra::vision {

struct FoundMark {
  std::string name;
  SeenPair pair;
  std::vector<cv::Point2d> elsewhere;
  double confidence = 0;
  std::optional<SeenRange> range = {};
  std::optional<MarkPose> pose = {};
};

struct FoundPlace {
  std::string name;
  cv::Point2d centre;  // in the left image, px
};

class MarkFinder {
 public:
  // `objects` outlives it.
  explicit MarkFinder(const LearnedObjects& objects) : objects_(objects) {}

  // Failures: `ambiguous`, `too-large`, `too-small`, `crowded`, and `not-seen` for whatever else.
  Result<FoundMark> find(StereoSight& sight, const LearnedObject& object, Time now);
  std::optional<cv::Point2d> place_of(const std::string& name) const;
  // The objects found then or later, each where it was found last.
  std::vector<FoundPlace> found_since(Time then) const;
  // As MarkTracker::rename().
  void rename(const Renames& renames);

 private:
  std::optional<SeenPair> surest(StereoSight& sight, const LearnedObject& object) const;
  std::optional<FoundMark> find_shape(StereoSight& sight, const LearnedObject& object) const;
  std::optional<FoundMark> find_tag(StereoSight& sight, const LearnedObject& object) const;
  // Why none of the marks is the object: like another one as much, or like none.
  Failure not_found(StereoSight& sight, const LearnedObject& object) const;

  const LearnedObjects& objects_;
  struct FoundAt {
    cv::Point2d place;
    Time when;
  };
  std::map<std::string, FoundAt> found_at_;  // each object's last
};

}  // namespace pizarra::vision
