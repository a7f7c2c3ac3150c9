#pragma once

// How light changes across a large mark, cell by cell, by the lighter of mark and ground; and the same picture as if it
// did not: gradients, darker corners and the edges of shadows.
//
//   LightMap light(patch.size());
//   light.add(patch.ptr<std::uint8_t>(y), y, first, end);      // runs of pixels that are all of one tone
//   light.divide_out(patch);

#include <opencv2/core.hpp>
#include <vector>

#include "agents/vision/image/grey_levels.hpp"

namespace pizarra::vision {

class LightMap {
 public:
  explicit LightMap(cv::Size size);

  void add(const std::uint8_t* row, int y, int first, int end);
  // The levels become what they would be in the light that is usual where pixels were added.
  void divide_out(cv::Mat1b& pixels) const;

 private:
  std::size_t cell_at(int x, int y) const;
  // Of each cell; what a cell cannot tell, or tells of something else that lies there, is as around it.
  std::vector<int> levels(int usual) const;
  int mean_around(const std::vector<int>& known, int cell) const;

  int columns_;
  int rows_;
  GreyLevels all_;
  std::vector<GreyLevels> cells_;
};

}  // namespace pizarra::vision
