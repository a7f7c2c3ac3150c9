#pragma once

// The camera's picture as a person likes to see it: twice the size, where it is small, with the contour, a cross, the
// name and x, y, d of each tracked object; a white cross, the name and x, y of what was found just now; red what is
// being filled while learning; a line that says what the eyes are doing.

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

namespace pizarra::vision {

struct Annotation {
  std::vector<TrackSighting> sightings;
  std::vector<FoundPlace> found;
  cv::Mat1b filled;             // may be empty; of another size than the picture it is not shown
  MarkContour learned_contour;  // may be empty
  std::string status;           // "frame 12  tracking"
};

// `base`: grey or BGR. The result is BGR.
std::shared_ptr<const Image> annotate(const Image& base, const Annotation& annotation);

}  // namespace pizarra::vision
