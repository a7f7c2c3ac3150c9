#pragma once

// One camera, or what stands for one, as its reader sees it: images one after another, each with its moment. Every call
// may block, and all come from one thread.
//
//   const std::unique_ptr<FrameSource> source = std::move(sources_of(setup)[0]);
//   Result<void> opened = source->open();
//   Result<std::optional<double>> moment_ms = source->grab();
//   Result<cv::Mat> image = source->retrieve(grey);
//
// Failures: disconnected (not there, or gone), refused-setting, corrupt-frame (this image, not the next), and ended for
// a recording that is over; open() then begins anew.

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "lisp/forms/camera_setup.hpp"
#include "lisp/result.hpp"

namespace pizarra::camera {

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual Result<void> open() = 0;
  virtual void close() = 0;
  // The next image is held, yet not decoded. Its moment by the source's own clock, where it has one that tells two of
  // its kind apart.
  virtual Result<std::optional<double>> grab() = 0;
  // The grabbed image, as often as it is asked for: 8 bit, not empty; as it comes, or `grey` where that saves work.
  virtual Result<cv::Mat> retrieve(bool grey) = 0;
  // A recording's own rate, 0: it comes as it comes. Known once open.
  virtual double recorded_hz() const = 0;
  // Images of a recording that have no partner on the other side, and are never given. Known once open.
  virtual std::size_t left_out() const { return 0; }
};

// The sources of a cell file's (camera ...), not opened yet: one, or the left camera's and the right one's.
std::vector<std::unique_ptr<FrameSource>> sources_of(const forms::CameraSetup& setup);

}  // namespace pizarra::camera
