#pragma once

// The pairs of images that a calibration is made of: image files named one by one, or what the cameras of a cell see.
// Of one camera alone the right images are empty.
//
//   std::unique_ptr<BoardPairs> pairs = BoardPairs::of_files("left*.jpg", "right*.jpg").value();
//   for (Result<ImagePair> pair = pairs->next(); !is_end(pair); pair = pairs->next()) ...

#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "lisp/forms/camera_setup.hpp"
#include "lisp/result.hpp"

namespace pizarra::programs {

struct ImagePair {
  cv::Mat left;
  cv::Mat right;
};

class BoardPairs {
 public:
  // Their fit takes ten seconds, and that of twice as many a minute.
  static constexpr std::size_t most = 50;

  // Folders or patterns, paired as a cell's camera pairs them (image_pairs.hpp); `right` is empty of one camera alone.
  // Failures: no-images, unpaired, too-many.
  static Result<std::unique_ptr<BoardPairs>> of_files(const std::string& left, const std::string& right);
  // Failures: those of the cameras, and no-camera where there is none of its own.
  static Result<std::unique_ptr<BoardPairs>> of_cameras(const forms::CameraSetup& eyes);

  virtual ~BoardPairs() = default;
  // Failures: corrupt-frame, which is about this pair alone; ended, when there is no more; any other: none can come.
  virtual Result<ImagePair> next() = 0;
  // Of the pair that came last, as a person knows it.
  virtual std::string name() const = 0;
  // How many images have no partner, and are never given.
  virtual std::size_t left_out() const { return 0; }
  // Whether a person chose each. Where none did, most show no board, or the same as the one before.
  virtual bool chosen() const = 0;
  virtual bool single() const = 0;
};

}  // namespace pizarra::programs
