#pragma once

// A sheet of paper to try the eyes with: marks as drawings in mm, on A4, for a printer.
//
//   const Sheet sheet = shapes_sheet();
//   Result<void> written = write_sheet("shapes.pdf", sheet);     // or .png

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::programs {

// From the upper left corner, y downwards, mm; black.
struct Sheet {
  static constexpr double width_mm = 210;
  static constexpr double height_mm = 297;
  struct Text {
    Eigen::Vector2d at_mm;  // where its first letter stands
    double height_mm;
    std::string words;
  };
  std::vector<std::vector<Eigen::Vector2d>> areas;  // convex
  std::vector<Text> texts;
};

// The four shapes apart, four cubes' faces with theirs between marks to cut along, and a bar of 100 mm.
Sheet shapes_sheet();
// The chessboard that `calibrate` looks for unless told otherwise: 10 x 7 squares of 25 mm.
Sheet board_sheet();
// The ChArUco board that it looks for likewise: the same squares, and tags of 18 mm of aruco-4x4-50 in the light ones.
Sheet charuco_sheet();

// Tags, as tags_from_text() reads them, apart, each with its number below it. Failures: those of it, too-many for a
// page, and too-small. Without a side their squares are 40 mm large, or those within a dark line 25 mm.
Result<Sheet> tags_sheet(const std::string& which, std::optional<double> side_mm);

// Parts of a sheet: an upright rectangle, and the bar that says whether a page was printed at its real size.
std::vector<Eigen::Vector2d> box_at(const Eigen::Vector2d& corner, const Eigen::Vector2d& size);
void add_scale(Sheet& sheet);

// What a printer prints at real size: PDF in lines, PNG at 300 dots an inch, which it says. By the name's ending.
// Failures: unknown-format, cannot-write.
Result<void> write_sheet(const std::string& path, const Sheet& sheet);

}  // namespace pizarra::programs
