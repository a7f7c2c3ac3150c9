#pragma once

// How sure TRACK is of a mark that it follows: that it is the object, and that nothing covers it. The track keeps what
// earlier looks have told.
//
//   const double told = pair.right ? confidence_before_pair(sight, track, pair, look.may_be_off_px)
//                                  : confidence_before_one(sight, track, object, pair, goes_on);
//
// Before one camera each look is judged as FIND judges it, but for two things. A mark that has been told surely stays
// the object while its outline is followed. A triangle that looks farther away than it did may be covered.

#include "agents/vision/sight/tracked_mark.hpp"

namespace pizarra::vision {

// `goes_on`: the outline of its plane, from that of the last frame.
double confidence_before_one(const StereoSight& sight, TrackedMark& track, const LearnedObject& object, SeenPair& now,
                             bool goes_on);
// `may_be_off_px`: how far off its centre may be, by what is remembered of it (wholeness.hpp).
double confidence_before_pair(const StereoSight& sight, TrackedMark& track, const SeenPair& now, double may_be_off_px);

}  // namespace pizarra::vision
