#include "drivers/camera/calibration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/guile/scheme.hpp"

namespace pizarra::camera {
namespace {

LensModel lens_from(const Datum& given) {
  LensModel lens{given[0].number(), given[1].number(), given[2].number(), given[3].number(), {}};
  for (std::size_t i = 0; i < lens.distortion.size(); ++i) lens.distortion[i] = given[4 + i].number();
  return lens;
}

Result<StereoCalibration> interpret_source(const Result<Source>& source) {
  if (!source) return fail(source);
  const Result<Datum> given = guile::interpret(*source, "calibration");
  if (!given) return fail(given);
  const Datum& file = *given;
  StereoCalibration out;
  out.width = static_cast<int>(file[0][0].number());
  out.height = static_cast<int>(file[0][1].number());
  out.left = lens_from(file[1]);
  const bool single = file[2].size() == 0;
  if (!single) out.right = lens_from(file[2]);
  for (std::size_t i = 0; i < out.rotation.size() && !single; ++i) out.rotation[i] = file[3][i].number();
  for (std::size_t i = 0; i < out.translation_mm.size() && !single; ++i) out.translation_mm[i] = file[4][i].number();
  out.board = {static_cast<int>(file[5][0].number()), static_cast<int>(file[5][1].number()), file[5][2].number()};
  out.pairs = static_cast<int>(file[6][0].number());
  out.reprojection_px = file[6][1].number();
  out.epipolar_px = file[6][2].number();
  out.deviations = {file[7][0].number(), file[7][1].number(), file[7][2].number()};
  return out;
}

std::string lens_text(const LensModel& lens) {
  return fmt::format("(focal {:.4f} {:.4f}) (centre {:.4f} {:.4f}) (distortion {:.8f})", lens.focal_x_px,
                     lens.focal_y_px, lens.centre_x_px, lens.centre_y_px, fmt::join(lens.distortion, " "));
}

}  // namespace

Result<StereoCalibration> read_calibration(std::string_view text, const std::string& file) {
  return interpret_source(read_source(text, file));
}

Result<StereoCalibration> read_calibration_file(const std::string& path) {
  return interpret_source(read_source_file(path));
}

std::string write_calibration(const StereoCalibration& c) {
  if (c.is_single()) {
    return fmt::format(
        "; A camera as `./pizarra calibrate` found it. Pixels and mm.\n"
        "(calibration\n"
        "  (size {} {})\n"
        "  (lens {})\n"
        "  (board {} {} {})      ; inner corners a row, rows, the edge of a square\n"
        "  (errors {} {:.4f})  ; images used, RMS of their corners\n"
        "  (deviations {:.4f} {:.4f}))  ; standard, of focal length and centre\n",
        c.width, c.height, lens_text(c.left), c.board.columns, c.board.rows, c.board.square_mm, c.pairs,
        c.reprojection_px, c.deviations.focal_px, c.deviations.centre_px);
  }
  return fmt::format(
      "; A pair of cameras as `./pizarra calibrate` found it. Pixels and mm; right = rotation left + translation.\n"
      "(calibration\n"
      "  (size {} {})\n"
      "  (left {})\n"
      "  (right {})\n"
      "  (rotation {:.10f})\n"
      "  (translation {:.4f})\n"
      "  (board {} {} {})            ; inner corners a row, rows, the edge of a square\n"
      "  (errors {} {:.4f} {:.4f})  ; pairs used, RMS of their corners, mean distance from the rectified rows\n"
      "  (deviations {:.4f} {:.4f} {:.4f}))  ; standard, of focal length, centre and base line\n",
      c.width, c.height, lens_text(c.left), lens_text(c.right), fmt::join(c.rotation, " "),
      fmt::join(c.translation_mm, " "), c.board.columns, c.board.rows, c.board.square_mm, c.pairs, c.reprojection_px,
      c.epipolar_px, c.deviations.focal_px, c.deviations.centre_px, c.deviations.base_line_mm);
}

}  // namespace pizarra::camera
