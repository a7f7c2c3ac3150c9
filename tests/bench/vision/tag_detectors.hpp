#pragma once

// The peers: detectors of tags.
//
//   for (TagDetector& peer : tag_detectors()) seconds_of([&] { peer.detect(image); });

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace pizarra::bench {

struct SeenTag {
  int number;
  cv::Point2d centre;
  std::vector<cv::Point2f> corners;  // clockwise from the left upper one, px
};

struct TagDetector {
  std::string name;
  std::vector<cv::Mat1b> tags;  // the dark cells of the first tags, by number
  std::function<std::vector<SeenTag>(const cv::Mat& grey)> detect;
};

inline constexpr int tags_of_a_scene = 5;

// ArUco and AprilTag.
std::vector<TagDetector> tag_detectors();

}  // namespace pizarra::bench
