#pragma once

// A pair of cameras that look the same way, a base line apart. One implementation a device; the simulated one is in
// drivers/simulation/, video_camera.hpp has the others.
//
// Lifecycle: open(), and again after a failure; then next(), with the time of the frame before.
//
//   const Result<StereoModel> model = co_await camera.open();
//   const Result<StereoFrame> frame = co_await camera.next(after, false);     // grey alone; waits for it

#include <cstdint>
#include <memory>
#include <string>

#include "blackboard/stream.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::camera {

struct StereoFrame {
  std::uint64_t number = 0;  // counts up from 1, gaps are dropped frames
  Time captured{};           // when it came from the device, not yet decoded; later of each frame than of those before
  std::shared_ptr<const Image> left;  // the reference
  std::shared_ptr<const Image> right;
};

// How far a pair's geometry may be off, as standard deviations: what its calibration left open. 0 where nothing is off,
// as in a simulation, and where nobody knows.
struct StereoDeviations {
  double focal_px = 0;
  double base_line_mm = 0;
  double disparity_px = 0;  // of a point, by how far the images are from being rectified
};

// A rectified pair: both images share the focal length and the centre row; base line along the rows. One camera alone
// is a pair with no base line, whose right images show nothing.
struct StereoModel {
  int width = 320;
  int height = 240;
  double focal_px = 431;
  double centre_x_px = 159.5;
  double centre_y_px = 119.5;
  double base_line_mm = 90;
  double learned_at_mm = 0;  // of one camera alone: how far away objects are while they are learned
  StereoDeviations deviations = {};

  bool is_single() const { return base_line_mm == 0; }
  // The same lenses before sensors that have so many pixels on the same area.
  StereoModel with_size(int width_px, int height_px) const {
    StereoModel out = *this;
    out.focal_px *= static_cast<double>(width_px) / width;
    out.width = width_px;
    out.height = height_px;
    out.centre_x_px = (width_px - 1) / 2.0;
    out.centre_y_px = (height_px - 1) / 2.0;
    return out;
  }
};

// Frames that were lost before anybody was given them.
struct CameraDrops {
  std::uint64_t late = 0;        // a newer one came before it was taken
  std::uint64_t skewed = 0;      // its partner was of another moment
  std::uint64_t corrupt = 0;     // it could not be read
  std::string why_corrupt = {};  // of the newest of those
  bool operator==(const CameraDrops&) const = default;
};

class StereoCamera {
 public:
  virtual ~StereoCamera() = default;
  virtual Task<Result<StereoModel>> open() = 0;
  // The newest frame, waiting for one that was captured later than `after`. Colour where asked for, else grey.
  // Failures: disconnected, corrupt-frame.
  virtual Task<Result<StereoFrame>> next(Time after, bool colour) = 0;
  // Since it was made.
  virtual CameraDrops drops() const { return {}; }
};

}  // namespace pizarra::camera
