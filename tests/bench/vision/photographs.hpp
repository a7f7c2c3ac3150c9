#pragma once

// Photographs that a script makes of sheets before real backgrounds, with their truth (photographs/). They share
// nothing with our renderers.
//
//   const PhotographSet set = make_photographs(folder, seed, 40);     // some minutes; read where the folder has them
//   for (const Photograph& photo : set.photographs) photo.left(), photo.marks ...

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "agents/vision/objects/learned.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::bench {

struct PhotographedMark {
  std::string name;    // circle ...; of a tag the shape in whose place it is
  cv::Point2d centre;  // of its centroid, px
  double hidden = 0;   // a part of its area
  cv::Vec3d place_mm;  // of its centroid, in the camera's frame
  cv::Matx33d turn;    // its axes: right, down and away, seen from the front
};

struct Photograph {
  std::string condition;
  std::string path;
  std::string kind;  // shapes, 4x4, 36h11
  std::vector<PhotographedMark> marks = {};

  cv::Mat1b left() const;
  cv::Mat1b right() const;  // of the conditions `learning` and `pair` alone
};

struct PhotographSet {
  Photograph learning;
  std::vector<Photograph> photographs;
};

// What took them: one camera, or with a base line a pair.
camera::StereoModel photographs_camera();
camera::StereoModel photographs_pair();

// Throws where the script, or what it needs, is missing.
PhotographSet make_photographs(const std::string& folder, std::uint64_t seed, int scenes);
// The four shapes, each by a click in the one photograph, or in both of a pair; throws where one cannot be learned.
vision::LearnedObjects learn_from(const Photograph& photo, const camera::StereoModel& model);
// The number of the tag that is in a shape's place.
int tag_in_place_of(const std::string& shape);

}  // namespace pizarra::bench
