#pragma once

// A stereo camera's driver as a plug-in (plugin.hpp).
//
//   class MyCamera : public pizarra::plugin::Camera { ... };
//   PIZARRA_CAMERA_PLUGIN(MyCamera)
//
// `(camera (plugin "libmycamera.so"))` in a cell file has the eyes look through it.

#include <cstdint>
#include <vector>

#include "drivers/plugin/plugin.hpp"

namespace pizarra::plugin {

// A rectified pair of this size and geometry; lengths in pixels and mm.
struct CameraModel {
  int width = 320;
  int height = 240;
  double focal_px = 431;
  double centre_x_px = 159.5;
  double centre_y_px = 119.5;
  double base_line_mm = 90;
};

// Rows from the top, WIDTH * HEIGHT bytes of grey, or three times as many of blue, green and red.
using Pixels = std::vector<std::uint8_t>;

struct CameraPair {
  std::uint64_t number = 0;  // counts up; gaps are dropped frames
  Pixels left;
  Pixels right;
};

class Camera {
 public:
  virtual ~Camera() = default;
  // Again after a failure, too.
  virtual CameraModel open() = 0;
  // The next pair, taken after this was called, waiting for it for a second at most.
  virtual CameraPair next(bool colour) = 0;
};

}  // namespace pizarra::plugin

#define PIZARRA_CAMERA_PLUGIN(CLASS)                              \
  extern "C" const int pizarra_plugin_abi = pizarra::plugin::abi; \
  extern "C" pizarra::plugin::Camera* pizarra_make_camera() { return new CLASS; }
