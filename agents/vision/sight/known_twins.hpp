#pragma once

// Where the marks are that look like a tracked object and stood elsewhere when it was found or seen last, so that they
// are others.
//
//   KnownTwins others;
//   others.note(own, marks, objects, object);          // it is seen, and so are these
//   others.follow(marks, objects, object);             // it is not; they may move meanwhile
//   sight.find(objects, object, {}, 0, others.places());

#include "agents/vision/objects/mark_choice.hpp"

namespace pizarra::vision {

class KnownTwins {
 public:
  static constexpr std::size_t most = 16;

  const std::vector<cv::Point2d>& places() const { return places_; }
  bool empty() const { return places_.empty(); }
  // Those of the marks that are like the object, and neither its own mark nor another face of its cube.
  void note(const SeenMark& own, const std::vector<SeenMark>& marks, const LearnedObjects& objects,
            const LearnedObject& object);
  void add(cv::Point2d place);
  // One that is hidden is thought to rest.
  void follow(const std::vector<SeenMark>& marks, const LearnedObjects& objects, const LearnedObject& object);

 private:
  std::vector<cv::Point2d> places_;
};

// Keeps the marks that rest, or go as the camera does. One that falls beside a lost object may be that object, or its
// cover. `motion`: the camera's, in the image; `most_px`: how far one that rests seems to move.
void drop_moved(std::vector<SeenMark>& marks, const std::vector<SeenMark>& now, cv::Point2d motion, double most_px);

}  // namespace pizarra::vision
