#pragma once

// The texts of the thesis' Table C.2, to the letter; numbers have two decimals.
//
//   (LEARN "name" OK)   (FIND "name" OK (112.25, 87.50))   (TRACK 2 ("a" OK (x, y, d)) ("b" FAIL))   (GET 2 ("a", "b"))

#include <span>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

namespace pizarra::vision {

std::string learn_reply(const std::string& name, bool ok);
// `place`: px, absent when it was not found.
std::string find_reply(const std::string& name, const std::optional<cv::Point2d>& place);
std::string track_reply(std::span<const TrackSighting> sightings);
std::string get_reply(std::span<const std::string> names);
std::string get_reply(const LearnedObjects& objects);

// ((left X Y) (right X Y) (range D SPREAD)): where both images show it, px, and how far away it is, mm. `right` and
// `range` are left out where they are not known.
struct SeenPlaces {
  cv::Point2d left;
  std::optional<cv::Point2d> right;
  double range_mm = 0;         // 0: not known
  double range_spread_mm = 0;  // a standard deviation
};
Datum places_datum(const SeenPlaces& places);

// (pose X Y Z RX RY RZ (C ...)): mm from the middle of the base line; degrees about x, then y, then z. C is the upper
// triangle of the covariance, of the place and of small turns about the camera's axes.
Datum pose_datum(const MarkPose& pose);

// (found NAME FRAME CONFIDENCE SECOND MARGIN ((X Y) ...) PLACES). The points are other places where it may be, eight at
// most. PLACES end with the pose where that is known, and (flipped RX RY RZ SHARE) where the other tilt is likely too.
Datum found_fact(std::uint64_t frame, const FoundMark& found);

// (tags-seen FRAME CAPTURED ((FAMILY NUMBER CONFIDENCE PART ...) ...)): the tags that a frame shows, with the parts of
// places_datum() and the pose; CAPTURED in microseconds since 1970. Of too many the largest.
inline constexpr std::size_t most_tags_told = 128;
Datum tags_fact(std::uint64_t frame, Time captured, std::span<const FoundMark> seen);

// One look: (look FRAME TEXT (("a" seen CONFIDENCE PART ...) ("b" bridged CONFIDENCE PART ...) ("c" lost) ...)). TEXT
// is track_reply(). Each PART begins with its name: those of places_datum(); (face DEGREES), how far its face looks to
// the right of the camera; (captured US), the frame that says so; (second NAME MARGIN), what it is most like otherwise
// and by how much less; and pose_datum(), where it is known, with (flipped RX RY RZ SHARE) where the other tilt may be
// it, and (by "mark" ...) where it is that of a body. Of one that was lost a moment ago the place is where it should
// be.
Datum look_fact(std::uint64_t frame, std::span<const TrackSighting> sightings);

// seen, bridged or lost.
std::string_view track_state(const TrackSighting& sighting);

}  // namespace pizarra::vision
