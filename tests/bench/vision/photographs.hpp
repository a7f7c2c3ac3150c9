#pragma once

// Photographs and films that scripts make of sheets before real backgrounds, with their truth (photographs/). They
// share nothing with our renderers.
//
//   const PhotographSet set = make_photographs(folder, seed, 40);     // some minutes; read where the folder has them
//   for (const Photograph& photo : set.photographs) photo.left(), photo.marks ...

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "agents/vision/objects/learned.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::bench {

// A position farther off is that of something else; a sure one may be off by so much; and so confident is sure.
inline constexpr double same_place_px = 5;
inline constexpr double sure_within_px = 1;
inline constexpr double surely = 0.9;

struct PhotographedMark {
  std::string name;    // circle ...; of a tag the shape in whose place it is
  cv::Point2d centre;  // of its centroid, px
  double hidden = 0;   // a part of its area
  cv::Vec3d place_mm;  // of its centroid, in the camera's frame
  cv::Matx33d turn;    // its axes: right, down and away, seen from the front
};

struct Photograph {
  std::string condition;  // or the film whose frame it is
  std::string path;
  std::string kind;  // shapes, 4x4, 36h11
  std::vector<PhotographedMark> marks = {};

  cv::Mat1b left() const;
  cv::Mat1b right() const;  // where it has one: of `learning`, of the condition `pair`, of every second film
  bool has_right() const;
};

struct PhotographSet {
  Photograph learning;
  std::vector<Photograph> photographs;
};

// Where they are kept: in the folder that a person names, or in one that goes with this.
class PhotographFolder {
 public:
  PhotographFolder(const std::string& named, const std::string& what);
  ~PhotographFolder();
  PhotographFolder(const PhotographFolder&) = delete;
  PhotographFolder& operator=(const PhotographFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool goes_;
};

// What took them: one camera, or with a base line a pair.
camera::StereoModel photographs_camera();
camera::StereoModel photographs_pair();

// Throws where the script, or what it needs, is missing.
PhotographSet make_photographs(const std::string& folder, std::uint64_t seed, int scenes);
// Films of ten seconds, frame by frame in their order.
PhotographSet make_films(const std::string& folder, std::uint64_t seed, int films);
// The four shapes, each by a click in the one photograph, or in both of a pair; throws where one cannot be learned.
vision::LearnedObjects learn_from(const Photograph& photo, const camera::StereoModel& model);
// The number of the tag that is in a shape's place.
int tag_in_place_of(const std::string& shape);

}  // namespace pizarra::bench
