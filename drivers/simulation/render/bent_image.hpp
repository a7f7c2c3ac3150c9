#pragma once

// The images of cameras whose lenses distort: made of those of a pinhole camera that sees a little more on every side.
//
//   const BentImage lens(camera);
//   Canvas straight = ...;                                    // as lens.straight() sees
//   lens.bend(straight, lens.showing(changed), bent);

#include <opencv2/core.hpp>

#include "drivers/simulation/render/canvas.hpp"

namespace pizarra::simulation {

class BentImage {
 public:
  // Of a checked one.
  explicit BentImage(const CameraConfig& camera);
  const camera::StereoModel& straight() const { return straight_; }
  // The part of the bent image that shows any of that part of the straight one.
  Rect showing(const Rect& straight) const;
  void bend(const Canvas& straight, const Rect& rect, Canvas& bent) const;

 private:
  camera::StereoModel straight_;
  // Where in the straight image each pixel of the bent one is found.
  cv::Mat1f columns_;
  cv::Mat1f rows_;
};

}  // namespace pizarra::simulation
