#pragma once

// The meaning of a camera setup's pixels, and the way from its images to a rectified pair: distortion taken out, and
// what one image shows in a row in the same row of the other.
//
//   Result<StereoGeometry> geometry = StereoGeometry::make(setup, calibration, image.size());
//   geometry->model();                                  // for depths
//   geometry->rectified(image, StereoGeometry::Side::left);

#include <opencv2/core.hpp>
#include <optional>

#include "drivers/camera/calibration.hpp"
#include "drivers/camera/stereo_camera.hpp"
#include "lisp/forms/camera_setup.hpp"

namespace pizarra::camera {

class StereoGeometry {
 public:
  enum class Side : std::uint8_t { left, right };

  // `calibration`: what the setup's file says, where it names one. Failures: wrong-size where that is of other images,
  // wrong-calibration where it is of a pair and the setup of one camera, or the other way round.
  static Result<StereoGeometry> make(const forms::CameraSetup& setup,
                                     const std::optional<StereoCalibration>& calibration, cv::Size image);
  explicit StereoGeometry(const StereoCalibration& calibration);

  const StereoModel& model() const { return model_; }
  // The same image where nothing is known to take out.
  cv::Mat rectified(const cv::Mat& image, Side side) const;
  // Where a point of the image is in the rectified one.
  cv::Point2d rectified(cv::Point2d point, Side side) const;
  // Where a point of the rectified image is in the image as the camera took it.
  cv::Point2d as_taken(cv::Point2d point, Side side) const;

 private:
  StereoGeometry() = default;
  struct Lens {
    cv::Matx33d camera = cv::Matx33d::eye();
    cv::Vec<double, 5> distortion;
    cv::Matx33d rotation;
    cv::Matx34d projection;
    cv::Mat map_whole;
    cv::Mat map_fraction;
  };
  static Lens lens_of(const LensModel& model);
  void see_with_one(const StereoCalibration& calibration);
  void see_with_two(const StereoCalibration& calibration);

  StereoModel model_;
  bool rectifies_ = false;
  Lens lenses_[2];
};

}  // namespace pizarra::camera
