// Sheets of tags.

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/marks/tag_text.hpp"
#include "programs/commands/print_sheet.hpp"

namespace pizarra::programs {
namespace {

using Eigen::Vector2d;

// Where tags may be, and how much of the sheet is around each: their ground, and a line to cut along, as a part of
// the side.
const Vector2d first_mm(15, 20);
const Vector2d last_mm(195, 272);
constexpr double around_of_side = 0.25;
constexpr double letter_mm = 3;
// Cells that a printer of 300 dots an inch draws with four dots.
constexpr double least_cell_mm = 0.34;

struct Grid {
  Grid(double side_mm)
      : step(side_mm * (1 + 2 * around_of_side), side_mm * (1 + 2 * around_of_side) + letter_mm),
        columns(static_cast<std::size_t>((last_mm - first_mm).x() / step.x())),
        rows(static_cast<std::size_t>((last_mm - first_mm).y() / step.y())) {}
  // The upper left corner of a tag's own square.
  Vector2d place(std::size_t i, double side_mm) const {
    const std::size_t row = i / columns;
    const Vector2d cell(static_cast<double>(i % columns), static_cast<double>(row));
    return first_mm + cell.cwiseProduct(step) + Vector2d::Constant(side_mm * around_of_side);
  }
  Vector2d step;
  std::size_t columns;
  std::size_t rows;
};

// Dark cells that lie side by side in a row, or, of the turned cells, in a column, are one area.
void add_runs(Sheet& sheet, const cv::Mat1b& cells, bool turned, const Vector2d& corner, double cell_mm) {
  const auto add = [&](int begin, int end, int row) {
    Vector2d at(begin, row);
    Vector2d size(end - begin, 1);
    if (turned) std::swap(at.x(), at.y());
    if (turned) std::swap(size.x(), size.y());
    sheet.areas.push_back(box_at(corner + cell_mm * at, cell_mm * size));
  };
  for (int row = 0; row < cells.rows; ++row) {
    for (int begin = 0; begin < cells.cols; ++begin) {
      int end = begin;
      while (end < cells.cols && cells(row, end) == 0) ++end;
      if (end > begin) add(begin, end, row);
      begin = end;
    }
  }
}

// Both ways, so that no printer leaves a light line between cells.
void add_tag(Sheet& sheet, const vision::TagFamily& family, int number, const Vector2d& corner, double side_mm) {
  const cv::Mat1b cells = vision::print_of(family, number);
  const double cell_mm = side_mm / cells.cols;
  add_runs(sheet, cells, false, corner, cell_mm);
  add_runs(sheet, cells.t(), true, corner, cell_mm);
}

}  // namespace

Result<Sheet> tags_sheet(const std::string& which, double side_mm) {
  const Result<std::vector<vision::Tag>> tags = vision::tags_from_text(which);
  if (!tags) return fail(tags);
  const vision::TagFamily& family = *vision::family_called(tags->front().family);
  const int cells = vision::print_of(family, 0).cols;
  if (side_mm < cells * least_cell_mm) {
    return fail("too-small",
                fmt::format("a printer cannot draw the {} cells of a tag of {:g} mm: {:.1f} mm is the least", cells,
                            side_mm, std::ceil(10 * cells * least_cell_mm) / 10));
  }
  const Grid grid(side_mm);
  if (tags->size() > grid.columns * grid.rows) {
    return fail("too-many",
                fmt::format("a page of A4 has room for {} tags of {:g} mm, and {} are wanted: name fewer, or smaller "
                            "ones with --side",
                            grid.columns * grid.rows, side_mm, tags->size()));
  }
  Sheet sheet;
  sheet.texts.push_back({{first_mm.x(), 14},
                         letter_mm,
                         fmt::format("Pizarra: tags of {}, the side of their square {:g} mm", family.name, side_mm)});
  for (std::size_t i = 0; i < tags->size(); ++i) {
    const Vector2d corner = grid.place(i, side_mm);
    add_tag(sheet, family, (*tags)[i].number, corner, side_mm);
    const double below = side_mm * (1 + around_of_side) + letter_mm;
    sheet.texts.push_back({corner + Vector2d(0, below), letter_mm, fmt::format("{}", (*tags)[i].number)});
  }
  add_scale(sheet);
  return sheet;
}

}  // namespace pizarra::programs
