#pragma once

// Image files as the eyes see them, one camera's, without a cell: grey, its distortion taken out where a calibration is
// given. `find` and `measure` look at these.
//
//   StillChoices choices;
//   add_still_options(*word, choices);
//   Result<StillCamera> camera = StillCamera::make(choices);
//   Result<StillImage> image = camera->see("shots/1.jpg");        // failures name the file
//   const vision::StereoSight sight = sight_of(*image);

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "agents/vision/sight/stereo_sight.hpp"
#include "drivers/camera/stereo_geometry.hpp"

namespace pizarra::programs {

struct StillChoices {
  double focal_px = 0;      // 0: not said
  std::string calibration;  // of one camera; empty: none
};

struct StillImage {
  std::string name;  // of the file, as text
  cv::Mat grey;
  camera::StereoGeometry geometry;
};

void add_still_options(CLI::App& word, StillChoices& choices);

void add_side_option(CLI::App& word, double& side_mm);

// The image outlives it.
vision::StereoSight sight_of(const StillImage& image);

// All images that the words name, files and folders, in the order of the words and of the names in a folder. Failures:
// no-images, of a word that names none; too-many.
Result<std::vector<std::string>> still_files(const std::vector<std::string>& words);

class StillCamera {
 public:
  // `learned_at_mm`: how far away marks are that are learned. Failures: those of a calibration file, and
  // wrong-calibration of one of a pair.
  static Result<StillCamera> make(const StillChoices& choices, double learned_at_mm = 0);

  // Whether it is known what a pixel is, so that places are.
  bool is_measured() const { return calibration_.has_value() || setup_.focal_px > 0; }
  // Failures: corrupt-frame, wrong-size.
  Result<StillImage> see(const std::string& file) const;

 private:
  forms::CameraSetup setup_;
  std::optional<camera::StereoCalibration> calibration_;
};

// Failure needless-option: the side of a tag tells nothing where it is not known what a pixel is.
Result<void> check_side(const StillCamera& camera, double side_mm);

}  // namespace pizarra::programs
