#include "programs/commands/calibrate_report.hpp"

#include <cstdio>
#include <fmt/format.h>

#include "drivers/camera/stereo_geometry.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::programs {

void CalibrateReport::pair(const std::string& name, const Result<void>& taken, const std::string& so_far) const {
  if (json_) {
    fmt::print("{{\"pair\":{},\"found\":{},\"reason\":{}}}\n", json_string(name), taken.has_value(),
               taken ? "null" : json_string(describe(taken.error())));
  } else {
    fmt::print("{}: {}{}\n", name, taken ? "board found" : describe(taken.error()), taken ? so_far : "");
  }
  std::fflush(stdout);
}

void CalibrateReport::without_partner(std::size_t images) const {
  if (json_) {
    fmt::print("{{\"without_partner\":{}}}\n", images);
  } else {
    fmt::print("{} {} no partner, going by the numbers in their names\n", images,
               images == 1 ? "image has" : "images have");
  }
}

void CalibrateReport::step(const std::string& what) const {
  json_ ? fmt::print("{{\"step\":{}}}\n", json_string(what)) : fmt::print("{} ...\n", what);
  std::fflush(stdout);
}

void CalibrateReport::left_out(const std::string& name, double px, const std::string& why) const {
  if (json_) {
    fmt::print("{{\"left_out\":{},\"error_px\":{},\"reason\":{}}}\n", json_string(name),
               px > 0 ? fmt::format("{:.4f}", px) : "null", json_string(why));
  } else {
    fmt::print("{}: left out, {}\n", name, why);
  }
}

void CalibrateReport::result(const std::string& file, const camera::CalibratedPair& found) const {
  for (const camera::ViewError& odd : found.left_out) {
    left_out(odd.name, odd.px, fmt::format("{:.1f} px off: it does not belong to the others", odd.px));
  }
  const camera::StereoCalibration& c = found.calibration;
  if (!json_) {
    fmt::print("{} {} of {} x {}\n", c.pairs, single_ ? "images" : "pairs", c.width, c.height);
    fmt::print("reprojection error {:.3f} px RMS, at most {:.3f} in {}\n", c.reprojection_px, found.worst.px,
               found.worst.name);
  }
  single_ ? lens_result(file, found) : pair_result(file, found);
}

void CalibrateReport::pair_result(const std::string& file, const camera::CalibratedPair& found) const {
  const camera::StereoCalibration& c = found.calibration;
  const camera::StereoModel model = camera::StereoGeometry(c).model();
  if (json_) {
    fmt::print(
        "{{\"file\":{},\"pairs\":{},\"reprojection_px\":{:.4f},\"worst_px\":{:.4f},\"worst\":{},"
        "\"epipolar_px\":{:.4f},\"focal_px\":{:.3f},\"base_line_mm\":{:.3f},\"focal_deviation_px\":{:.3f},"
        "\"centre_deviation_px\":{:.3f},\"base_line_deviation_mm\":{:.3f}}}\n",
        json_string(file), c.pairs, c.reprojection_px, found.worst.px, json_string(found.worst.name), c.epipolar_px,
        model.focal_px, model.base_line_mm, c.deviations.focal_px, c.deviations.centre_px, c.deviations.base_line_mm);
    return;
  }
  fmt::print("rectified, a corner's rows differ by {:.3f} px\n", c.epipolar_px);
  fmt::print("focal length {:.1f} px, base line {:.2f} mm\n", model.focal_px, model.base_line_mm);
  fmt::print("standard deviations: focal length {:.2f} px, centre {:.2f} px, base line {:.3f} mm\n",
             c.deviations.focal_px, c.deviations.centre_px, c.deviations.base_line_mm);
  const std::string shown = text_of_bytes(file);
  fmt::print("{} written; in the cell file: (camera ... (calibration \"{}\"))\n", shown, shown);
}

void CalibrateReport::lens_result(const std::string& file, const camera::CalibratedPair& found) const {
  const camera::StereoCalibration& c = found.calibration;
  if (json_) {
    fmt::print(
        "{{\"file\":{},\"images\":{},\"reprojection_px\":{:.4f},\"worst_px\":{:.4f},\"worst\":{},"
        "\"focal_px\":{:.3f},\"focal_deviation_px\":{:.3f},\"centre_deviation_px\":{:.3f}}}\n",
        json_string(file), c.pairs, c.reprojection_px, found.worst.px, json_string(found.worst.name), c.left.focal_x_px,
        c.deviations.focal_px, c.deviations.centre_px);
    return;
  }
  fmt::print("focal length {:.1f} px across, {:.1f} down; centre {:.1f} {:.1f}; distortion k1 {:.3f}, k2 {:.3f}\n",
             c.left.focal_x_px, c.left.focal_y_px, c.left.centre_x_px, c.left.centre_y_px, c.left.distortion[0],
             c.left.distortion[1]);
  fmt::print("standard deviations: focal length {:.2f} px, centre {:.2f} px\n", c.deviations.focal_px,
             c.deviations.centre_px);
  const std::string shown = text_of_bytes(file);
  fmt::print("{} written; in the cell file: (camera (single ...) (calibration \"{}\"))\n", shown, shown);
}

}  // namespace pizarra::programs
