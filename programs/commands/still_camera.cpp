#include "programs/commands/still_camera.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "drivers/camera/image_faults.hpp"
#include "drivers/camera/image_files.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {
namespace {

constexpr std::size_t most_stills = 100'000;

Result<std::vector<std::string>> still_files(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  for (const std::string& word : words) {
    std::error_code error;
    if (!std::filesystem::is_directory(word, error)) {
      out.push_back(word);
      continue;
    }
    const std::vector<std::string> inside = camera::image_files_at(word);
    if (inside.empty()) return fail("no-images", text_of_bytes(camera::no_images_at(word)));
    out.insert(out.end(), inside.begin(), inside.end());
    if (out.size() > most_stills) {
      return fail("too-many", fmt::format("these are more than {} images: name fewer at once", most_stills));
    }
  }
  return out;
}

}  // namespace

void add_image_option(CLI::App& word, StillChoices& choices) {
  word.add_option("IMAGE", choices.images, "Image files of one camera, or folders of them")->required();
}

void add_still_options(CLI::App& word, StillChoices& choices) {
  CLI::Option* const focal =
      word.add_option("--focal", choices.focal_px, "The camera's focal length, px: places in space are told by it")
          ->check(number_check(10, 100000));
  word.add_option("--calibration", choices.calibration,
                  "Instead: what `calibrate` found of the one camera; its distortion is taken out before anything is "
                  "looked for")
      ->check(CLI::ExistingFile)
      ->excludes(focal);
  word.add_option("--side", choices.side_mm,
                  "The side of the tags' square, mm: with --focal or --calibration their poses are told")
      ->check(number_check(1, 5000));
}

vision::StereoSight sight_of(const StillImage& image) {
  return {image.grey, cv::Mat::zeros(image.grey.size(), CV_8U), image.geometry.model()};
}

Result<StillCamera> StillCamera::make(const StillChoices& choices, double learned_at_mm) {
  StillCamera out;
  out.setup_.arrangement = forms::CameraSetup::Arrangement::single;
  out.setup_.focal_px = choices.focal_px;
  out.setup_.learned_at_mm = learned_at_mm;
  if (choices.calibration.empty()) return out;
  out.setup_.calibration_file = text_of_bytes(choices.calibration);
  Result<camera::StereoCalibration> calibration = camera::read_calibration_file(choices.calibration);
  if (!calibration) return fail(calibration);
  if (!calibration->is_single()) {
    return fail("wrong-calibration",
                fmt::format("{} is of a pair of cameras, and these are images of one", out.setup_.calibration_file));
  }
  out.calibration_ = std::move(*calibration);
  return out;
}

Result<StillImage> StillCamera::see(const std::string& file) const {
  const Result<cv::Mat> grey = camera::read_image_file(file, true);
  if (!grey) return fail(grey);
  const std::string name = text_of_bytes(file);
  if (std::min(grey->cols, grey->rows) < camera::least_side_px) {
    return fail("wrong-size", fmt::format("{} is {}x{} px, and at least {} px each way are needed", name, grey->cols,
                                          grey->rows, camera::least_side_px));
  }
  Result<camera::StereoGeometry> geometry = camera::StereoGeometry::make(setup_, calibration_, grey->size());
  if (!geometry) return fail(geometry);
  cv::Mat rectified = geometry->rectified(*grey, camera::StereoGeometry::Side::left);
  return StillImage{name, std::move(rectified), std::move(*geometry)};
}

Result<Stills> Stills::open(const StillChoices& choices, double learned_at_mm) {
  Result<StillCamera> camera = StillCamera::make(choices, learned_at_mm);
  if (!camera) return fail(camera);
  if (choices.side_mm > 0 && !camera->is_measured()) {
    return fail("needless-option", "--side tells nothing without --focal or --calibration");
  }
  Result<std::vector<std::string>> files = still_files(choices.images);
  if (!files) return fail(files);
  return Stills(std::move(*camera), std::move(*files), choices.style());
}

int Stills::each(const std::function<int(const StillImage&)>& look) const {
  int status = exit_reached;
  for (const std::string& file : files_) {
    const Result<StillImage> image = camera_.see(file);
    status = std::max(status, image ? look(*image) : complain_as(style_, image.error(), exit_unavailable));
  }
  return status;
}

}  // namespace pizarra::programs
