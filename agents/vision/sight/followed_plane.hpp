#pragma once

// How the plane of a mark lies, by both images of a pair where both show the mark: its outline registered in the left
// one, and from there in the right one. A followed mark is registered in each frame, starting from the last frame's
// outline moved by the mark's shift.
//
//   FollowedPlane plane;
//   std::optional<FollowedLook> lies = plane.look(sight, object, pair);     // each frame that shows the mark
//
// An image without perspective allows two tilts. Which of them is likelier, frames say together.

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {

// The outline in the right image, from where it is in the left one; nothing where that does not show it.
std::optional<PlaneFit> fit_in_right(const StereoSight& sight, const LearnedSample& sample, const SeenPair& pair,
                                     const PlaneFit& left, const PlaneSearch& search);

struct FollowedLook {
  PlaneView view;  // with its pose, and, before one camera, with the ground
  bool goes_on;    // from the outline of the last frame
};

class FollowedPlane {
 public:
  // Nothing of a tag, and where what is seen is not the outline; then it begins anew. The likelier tilt so far, its
  // misfits those of all frames.
  std::optional<FollowedLook> look(const StereoSight& sight, const LearnedObject& object, const SeenPair& now);
  // In the right image, of which no region shows it alone: by its outline, where that goes on there from the last
  // frame, moved to where it is expected, and is registered all around.
  std::optional<SeenMark> follow_in_right(const StereoSight& sight, const LearnedObject& object, const SeenMark& right,
                                          cv::Point2d expected) const;
  // By its outline, which goes on from the last frame and shows all of it, however far aslant the mark is by now.
  bool recognises(const StereoSight& sight, const LearnedObject& object, const SeenMark& left) const;

 private:
  // Its outline of the last frame, moved to where the mark is now.
  cv::Matx33d start_at(const SeenMark& left) const;

  struct Seen {
    int sample;  // its number
    cv::Point2d centre;
    cv::Matx33d to_image;  // in the left image
    std::optional<cv::Matx33d> to_right;
    cv::Matx33d turn;  // of the face, as it was told
    double for_told;   // how much all frames speak for that rather than for the other tilt
  };
  static double weigh_tilts(const std::optional<Seen>& before, PlanePose& pose);

  std::optional<Seen> before_;
};

}  // namespace pizarra::vision
