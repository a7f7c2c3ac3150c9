#pragma once

// The pairs of images that a calibration is made of: image files named one by one, or what the cameras of a cell see.
// Of one camera alone the right images are empty.
//
//   std::unique_ptr<BoardPairs> pairs = BoardPairs::of_files("left*.jpg", "right*.jpg").value();
//   while (std::optional<Result<ImagePair>> pair = pairs->next()) ...

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "lisp/forms/camera_setup.hpp"
#include "lisp/result.hpp"

namespace pizarra {

struct ImagePair {
  cv::Mat left;
  cv::Mat right;
};

class BoardPairs {
 public:
  // Folders or patterns; `right` is empty of one camera alone. Failures: no-images, uneven.
  static Result<std::unique_ptr<BoardPairs>> of_files(const std::string& left, const std::string& right);
  // Failures: those of the cameras, and no-camera where there is none of its own.
  static Result<std::unique_ptr<BoardPairs>> of_cameras(const CameraSetup& eyes);

  virtual ~BoardPairs() = default;
  // The next pair, nothing when there is none; a failure is about this one alone.
  virtual std::optional<Result<ImagePair>> next() = 0;
  // Of the pair that came last, as a person knows it.
  virtual std::string name() const = 0;
  // Whether there are as many as one likes: they are then taken while the board moves.
  virtual bool endless() const = 0;
  virtual bool single() const = 0;
};

}  // namespace pizarra
