#pragma once

// Which mark of one image is one of the image before, where a hand took both: everything has moved, turned a little,
// come nearer. Marks that look alike are told apart by what lies around them.
//
//   const MarkedImage now = marked_image(sight.left(), sight.left_segmentation().marks());
//   const Refound found = refind(clicked, before, now);
//   if (found.mark != nullptr) ...                  // one of now.marks
//
// It is no guess: where the images fit as well if it were another of its like, none is found, and that is said.

#include <vector>

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

struct MarkedImage {
  cv::Size size;
  std::vector<SeenMark> marks;
  cv::Mat1f relief;  // what is lighter and darker than what lies around it, small
};
MarkedImage marked_image(const cv::Mat& grey, std::vector<SeenMark> marks);

struct Refound {
  const SeenMark* mark = nullptr;
  bool ambiguous = false;
};

// `before`: that `mark` was seen in, of the same size.
Refound refind(const SeenMark& mark, const MarkedImage& before, const MarkedImage& now);

}  // namespace pizarra::vision
