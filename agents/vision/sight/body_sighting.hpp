#pragma once

// How tracking tells a body: as one object, whichever of its marks are in sight.
//
//   std::string front;                                       // kept from look to look
//   const TrackSighting box = body_sighting(body, tracker.update(sight, captured), front);
//
// Its centre, its range and how sure it is are those of one mark in sight, which is called its front: the one that
// looks at the cameras most. Its pose is that of the body's own axes, by all of its marks.

#include "agents/vision/sight/body_pose.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

namespace pizarra::vision {

// `front`: by which mark it was told last, empty at first. It stays the front until another mark looks at the cameras
// clearly more, and is set anew.
TrackSighting body_sighting(const Body& body, std::span<const TrackSighting> tracked, std::string& front);

// Where in the left image each mark that this look does not show can come into sight in the next, by those of its body
// that it shows: empty for one that is turned away. Nothing where the look shows no mark of the body.
std::map<std::string, cv::Rect> areas_of_unseen(const Body& body, std::span<const TrackSighting> tracked, Time captured,
                                                double focal_px);

}  // namespace pizarra::vision
