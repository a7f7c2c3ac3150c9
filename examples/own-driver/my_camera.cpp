// A stereo camera of one's own as a plug-in. Its pictures are drawn here: a dark square, 970 mm away, that sways before
// a bright wall. Put the calls of your camera's library where it says so.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "drivers/plugin/camera_plugin.hpp"

using namespace pizarra::plugin;
using Clock = std::chrono::steady_clock;

class MyCamera : public Camera {
 public:
  // Open the device, and say what a pixel of its rectified images means.
  CameraModel open() override {
    due_ = Clock::now();
    return model_;
  }

  // Wait for the device's next pair.
  CameraPair next(bool colour) override {
    due_ = std::max(due_ + std::chrono::milliseconds(100), Clock::now());
    std::this_thread::sleep_until(due_);
    const double seconds = std::chrono::duration<double>(due_.time_since_epoch()).count();
    const double middle = model_.centre_x_px + 8 * std::sin(seconds);
    return {++number_, picture(middle + disparity_px / 2, colour), picture(middle - disparity_px / 2, colour)};
  }

 private:
  static constexpr double disparity_px = 40;  // what is as far away as focal length * base line / this
  static constexpr double half_px = 24;

  // How much of the pixel at this distance from the square's middle is dark.
  static double covered(double distance) { return std::clamp(half_px + 0.5 - std::abs(distance), 0.0, 1.0); }

  Pixels picture(double middle_x, bool colour) const {
    Pixels pixels;
    for (int y = 0; y < model_.height; ++y) {
      for (int x = 0; x < model_.width; ++x) {
        const double dark = covered(x - middle_x) * covered(y - model_.centre_y_px);
        pixels.insert(pixels.end(), colour ? 3 : 1, static_cast<std::uint8_t>(200 - 160 * dark));
      }
    }
    return pixels;
  }

  CameraModel model_;  // 320 x 240 pixels
  std::uint64_t number_ = 0;
  Clock::time_point due_{};
};

PIZARRA_CAMERA_PLUGIN(MyCamera)
