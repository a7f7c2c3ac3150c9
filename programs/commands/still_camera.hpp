#pragma once

// Image files as the eyes see them, one camera's, without a cell: grey, its distortion taken out where a calibration is
// given. `find` and `measure` look at these.
//
//   StillChoices choices;
//   add_image_option(*word, choices);
//   add_still_options(*word, choices);
//   Result<Stills> stills = Stills::open(choices);
//   return stills->each([](const StillImage& image) { sight_of(image) ...; return exit_reached; });

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agents/vision/sight/mark_finder.hpp"
#include "drivers/camera/stereo_geometry.hpp"
#include "programs/commands/board_session.hpp"

namespace pizarra::programs {

struct StillChoices {
  std::vector<std::string> images;
  double focal_px = 0;      // 0: not said
  std::string calibration;  // of one camera; empty: none
  double side_mm = 0;       // of tags; 0: not said
  bool json = false;

  repl::Style style() const { return json ? repl::Style::json : repl::Style::text; }
};

struct StillImage {
  std::string name;  // of the file, as text
  cv::Mat grey;      // without the lens' distortion, where that is known
  camera::StereoGeometry geometry;

  // Where a point of it is in the file's image.
  cv::Point2d in_file(cv::Point2d point) const { return geometry.as_taken(point, camera::StereoGeometry::Side::left); }
};

void add_image_option(CLI::App& word, StillChoices& choices);
// --focal, --calibration and --side.
void add_still_options(CLI::App& word, StillChoices& choices);

// The image outlives it.
vision::StereoSight sight_of(const StillImage& image);

class StillCamera {
 public:
  // `learned_at_mm`: how far away marks are that are learned. Failures: those of a calibration file, and
  // wrong-calibration of one of a pair.
  static Result<StillCamera> make(const StillChoices& choices, double learned_at_mm = 0);

  // Whether the size of a pixel is known, so that places can be told.
  bool is_measured() const { return calibration_.has_value() || setup_.focal_px > 0; }
  // Failures: corrupt-frame, wrong-size.
  Result<StillImage> see(const std::string& file) const;

 private:
  forms::CameraSetup setup_;
  std::optional<camera::StereoCalibration> calibration_;
};

// The images that a command's words name, files and folders, in the order of the words and of the names in a folder.
class Stills {
 public:
  // Failures: those of StillCamera::make(); no-images, where a word names none; too-many; and needless-option: the side
  // of a tag is of no use unless the size of a pixel is known.
  static Result<Stills> open(const StillChoices& choices, double learned_at_mm = 0);

  const StillCamera& camera() const { return camera_; }
  // Null if the size of a pixel, or of the tag, is not known.
  const vision::MarkPose* pose_of(const vision::FoundMark& found) const {
    return camera_.is_measured() && found.pose ? &*found.pose : nullptr;
  }
  // Says which images cannot be read. Answers the worst exit status: of that, or of what `look` answered.
  int each(const std::function<int(const StillImage&)>& look) const;

 private:
  Stills(StillCamera camera, std::vector<std::string> files, repl::Style style)
      : camera_(std::move(camera)), files_(std::move(files)), style_(style) {}

  StillCamera camera_;
  std::vector<std::string> files_;
  repl::Style style_;
};

}  // namespace pizarra::programs
