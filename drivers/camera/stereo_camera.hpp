#pragma once

// A pair of cameras that look the same way, a base line apart. One implementation a device; the simulated one is in
// drivers/simulation/.

#include <cstdint>
#include <memory>

#include "blackboard/stream.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra {

struct StereoFrame {
  std::uint64_t number = 0;  // counts up from 1, gaps are dropped frames
  Time captured{};
  std::shared_ptr<const Image> left;  // the reference
  std::shared_ptr<const Image> right;
};

// A rectified pair: both images share the focal length and the centre row; base line along the rows.
struct StereoModel {
  int width = 320;
  int height = 240;
  double focal_px = 431;
  double centre_x_px = 159.5;
  double centre_y_px = 119.5;
  double base_line_mm = 90;
};

class StereoCamera {
 public:
  virtual ~StereoCamera() = default;
  virtual Task<Result<StereoModel>> open() = 0;
  // The first frame with a number above `after`, waiting for it. Colour where asked for, else grey.
  // Failures: disconnected, corrupt-frame.
  virtual Task<Result<StereoFrame>> next(std::uint64_t after, bool colour) = 0;
};

}  // namespace pizarra
