#pragma once

// Follows several objects from frame to frame in both images. Each object is found once; then its closed contour is
// followed from where its motion predicts its centre. Where that fails, it is looked for nearby and then everywhere, in
// this same frame and in every later one, while the others go on. The mark is recognised anew in every frame: a hand,
// the gripper or another cube in its place is a loss, never a position. A cover over a part of it is a loss too. It
// only lowers the confidence where the centre is hardly off for that, or where the cover cannot be known
// (wholeness.hpp). The edge of a shadow over it is none (shadowed_mark.hpp). A loss of half a second is bridged: the
// object is expected where its motion would have brought it, and is said not to be seen. For so long, a mark of another
// size elsewhere is not taken for it. A mark that looked like it elsewhere, in the image in which it was found or in
// that in which it was seen last, never is. A mark that was in neither image may be another object. So one that is
// found elsewhere than where it was lost is not sure at first. It must have been followed for as long as it had been
// lost, from half a second to five. Where the lost one is seen again meanwhile, it is there. Where others like it were
// there from the first, it may be one of those, and is not sure while they are in view.
//
// An object may be looked for in an area only, and at a rate of its own (search_limits.hpp). Outside the area it is not
// seen. In a frame in which its turn is not due it stands as it was told last. A caller that knows where an
// object can be in one frame, as a mark of a body in sight, says so before that frame.
//
//   MarkTracker tracker(objects);
//   tracker.add(*objects.find("circle"));
//   StereoSight sight(left, right, model);
//   for (const TrackSighting& sighting : tracker.update(sight, frame.captured)) ...

#include <set>

#include "agents/vision/objects/renames.hpp"
#include "agents/vision/sight/confined_sights.hpp"
#include "agents/vision/sight/mark_pose.hpp"
#include "agents/vision/sight/search_limits.hpp"
#include "agents/vision/sight/tracked_mark.hpp"

namespace pizarra::vision {

struct TrackSighting {
  std::string name;
  bool seen = false;
  // Not seen, but so shortly that its place is told as its motion predicts it.
  bool bridged = false;
  Time captured = {};                            // of the frame that says so
  cv::Point2d centre;                            // in the left image, px: of its plane, or of its picture
  std::optional<cv::Point2d> right_centre = {};  // the same in the right one, where that shows it
  double range_mm = 0;                           // by the pair, or by its size where the right image ends before it
  double range_spread_mm = 0;                    // a standard deviation; 0 where it is not seen
  double confidence = 0;                         // that it is the object, and whole; of a bridged one less and less
  std::string second = {};        // the learned object that it is most like otherwise, where one comes near
  double margin = 0;              // Likeness::margin()
  std::optional<double> yaw_deg;  // of its face (face_plane.hpp), where both images show it
  std::optional<MarkPose> pose = {};
  std::vector<std::string> by = {};  // of a body: the marks by which its pose is told (body_sighting.hpp)
  MarkContour contour;               // in the left image
};

// All that can be known. Forgotten ones that are still asked for count too.
inline constexpr std::size_t most_tracked = most_objects;

class MarkTracker {
 public:
  // Both outlive it. An object that is not among them any more is not seen.
  explicit MarkTracker(const LearnedObjects& objects, const SearchLimits& limits = SearchLimits::none())
      : objects_(objects), limits_(limits) {}

  // Once more is harmless. Of several that are alike it begins with the one nearest to `seen_last`. Failure `full`.
  Result<void> add(const LearnedObject& object, std::optional<cv::Point2d> seen_last = {});
  // A tracked object is tracked on under its new name, and only once: the object that bore this name has been
  // forgotten.
  void rename(const Renames& renames);
  void keep_only(const std::set<std::string>& names) {
    std::erase_if(tracks_, [&](const TrackedMark& track) { return !names.contains(track.name); });
    std::erase_if(paced_, [&](const auto& each) { return !names.contains(each.first); });
  }
  void clear() { keep_only({}); }
  bool empty() const { return tracks_.empty(); }

  // In the next frame these objects are looked for there alone, of the left image, where no limit says otherwise; in an
  // empty area not at all.
  void look_within(std::map<std::string, cv::Rect> areas) { within_ = std::move(areas); }
  // One sighting an object, the end-effector first, then in the order added. The pixels of the left image must stay
  // until the next one has been seen.
  std::vector<TrackSighting> update(StereoSight& sight, Time captured);
  // Where no image came until now: nothing is seen, and what was is bridged for as long as ever. None before the first.
  std::vector<TrackSighting> miss_all(Time now);

 private:
  std::optional<SeenPair> follow(StereoSight& sight, const TrackedMark& track, const LearnedObject& object) const;
  // Of the marks in the image in which it was seen last; where there is a frame since, of those that this shows there
  // too.
  void note_others_before(TrackedMark& track, const LearnedObject& object, StereoSight* now);
  // Looks at it, or tells what was told last.
  TrackSighting look_in_turn(ConfinedSights& sights, TrackedMark& track);
  TrackSighting update(StereoSight& sight, TrackedMark& track);
  struct SeenWhole {
    SeenPair pair;  // with its plane, where that is registered
    Wholeness::Look look;
    bool goes_on;  // its outline, from that of the last frame
    FollowedPlane plane;
  };
  SeenWhole look_at(const StereoSight& sight, const TrackedMark& track, const LearnedObject& object,
                    SeenPair pair) const;
  void find_in_right(StereoSight& sight, const TrackedMark& track, const LearnedObject& object, SeenPair& pair) const;
  std::optional<Likeness> likeness_by_outline(const StereoSight& sight, const TrackedMark& track,
                                              const LearnedObject& object, const SeenMark& mark) const;
  std::optional<SeenWhole> see(StereoSight& sight, TrackedMark& track, const LearnedObject& object);
  struct Confidence {
    double told;
    double in_whole;  // that nothing covers it
  };
  Confidence confidence_in(StereoSight& sight, TrackedMark& track, const LearnedObject& object, SeenWhole& seen) const;
  void measure(StereoSight& sight, TrackedMark& track, const LearnedObject& object, const SeenWhole& seen,
               double in_whole, TrackSighting& out) const;
  TrackSighting miss(TrackedMark& track, Time now) const;
  // It was seen before, and is not now. Null: there is no frame.
  void note_loss(TrackedMark& track, const LearnedObject& object, StereoSight* now);
  // Goes back to the mark where it was lost, where it is hidden no more: the one followed elsewhere was another.
  void come_back(StereoSight& sight, TrackedMark& track, const LearnedObject& object, SeenPair& now) const;
  // Counts the others like it that are in view, where it may have been one of them from the first.
  void count_twins(StereoSight& sight, TrackedMark& track, const LearnedObject& object, SeenPair& now) const;

  // Of an object that is not looked at in every frame, how it was told last, and of which left image.
  struct Paced {
    LookPace pace = {};
    TrackSighting told = {};
    cv::Mat left = {};
  };

  const LearnedObjects& objects_;
  const SearchLimits& limits_;
  std::vector<TrackedMark> tracks_;
  std::map<std::string, Paced> paced_;
  std::map<std::string, cv::Rect> within_;  // for the next frame
  // Of the frame in hand, and since the one before it.
  Time captured_ = {};
  double frame_s_ = 0;
  // The left image before, looked at only where something was lost since.
  cv::Mat last_left_;
  std::optional<ImageSegmentation> last_segmentation_;
  cv::Size image_size_;  // of the frame looked at last
};

inline constexpr std::string_view end_effector_name = "end-effector";

}  // namespace pizarra::vision
