// Sheets of tags.

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/marks/tag_text.hpp"
#include "drivers/camera/charuco.hpp"
#include "programs/commands/print_sheet.hpp"

namespace pizarra::programs {
namespace {

using Eigen::Vector2d;

// Where tags may be, and how much of the sheet is around each, as a part of its width: its ground, and a line to cut
// along. Wide tags need no ground.
const Vector2d first_mm(15, 20);
const Vector2d last_mm(195, 272);
constexpr double ground_of_width = 0.25;
constexpr double cut_of_width = 0.1;
// Unless another is wanted. Of either kind twelve fit.
constexpr double side_of_dark_mm = 40;
constexpr double side_of_light_mm = 25;
constexpr double letter_mm = 3;
// Cells that a printer of 300 dots an inch draws with four dots.
constexpr double least_cell_mm = 0.34;

// A sheet's places for the tags of a family.
struct Grid {
  Grid(const vision::TagFamily& family, double side)
      : side_mm(side),
        cells(vision::print_of(family, 0).cols),
        side_cells(cells - 2 * family.cells_around),
        around_mm(width_mm() * (family.is_wide() ? cut_of_width : ground_of_width)),
        step(width_mm() + 2 * around_mm, width_mm() + 2 * around_mm + letter_mm),
        columns(static_cast<std::size_t>((last_mm - first_mm).x() / step.x())),
        rows(static_cast<std::size_t>((last_mm - first_mm).y() / step.y())) {}
  double cell_mm() const { return side_mm / side_cells; }
  double width_mm() const { return cell_mm() * cells; }
  // The upper left corner of a tag.
  Vector2d place(std::size_t i) const {
    const std::size_t row = i / columns;
    const Vector2d cell(static_cast<double>(i % columns), static_cast<double>(row));
    return first_mm + cell.cwiseProduct(step) + Vector2d::Constant(around_mm);
  }
  double side_mm;
  int cells;
  int side_cells;
  double around_mm;
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
void add_tag(Sheet& sheet, const cv::Mat1b& cells, const Vector2d& corner, double cell_mm) {
  add_runs(sheet, cells, false, corner, cell_mm);
  add_runs(sheet, cells.t(), true, corner, cell_mm);
}

}  // namespace

Result<Sheet> tags_sheet(const std::string& which, std::optional<double> side_mm) {
  const Result<std::vector<vision::Tag>> tags = vision::tags_from_text(which);
  if (!tags) return fail(tags);
  const vision::TagFamily& family = *vision::family_called(tags->front().family);
  const Grid grid(family, side_mm.value_or(family.is_wide() ? side_of_light_mm : side_of_dark_mm));
  if (grid.cell_mm() < least_cell_mm) {
    return fail("too-small",
                fmt::format("a printer cannot draw the {} cells of a tag of {:g} mm: {:.1f} mm is the least",
                            grid.side_cells, grid.side_mm, std::ceil(10 * grid.side_cells * least_cell_mm) / 10));
  }
  if (tags->size() > grid.columns * grid.rows) {
    return fail("too-many",
                fmt::format("a page of A4 has room for {} tags of {:g} mm, and {} are wanted: name fewer, or smaller "
                            "ones with --side",
                            grid.columns * grid.rows, grid.side_mm, tags->size()));
  }
  Sheet sheet;
  sheet.texts.push_back({{first_mm.x(), 14},
                         letter_mm,
                         fmt::format("Pizarra: tags of {}, the side of their {}square {:g} mm", family.name,
                                     family.is_wide() ? "light " : "", grid.side_mm)});
  for (std::size_t i = 0; i < tags->size(); ++i) {
    const Vector2d corner = grid.place(i);
    add_tag(sheet, vision::print_of(family, (*tags)[i].number), corner, grid.cell_mm());
    const double below = grid.width_mm() + grid.around_mm + letter_mm;
    sheet.texts.push_back({corner + Vector2d(0, below), letter_mm, fmt::format("{}", (*tags)[i].number)});
  }
  add_scale(sheet);
  return sheet;
}

// The page stands where the board lies: the board is turned by a quarter, clockwise.
Sheet charuco_sheet() {
  camera::CalibrationBoard board;
  const camera::BoardTags& kind = board.tags.emplace();
  const Vector2d first((Sheet::width_mm - (board.rows + 1) * board.square_mm) / 2, 16);
  const double right_mm = Sheet::width_mm - first.x();
  const auto on_page = [&](const Vector2d& corner, double side) {
    return Vector2d(right_mm - corner.y() - side, first.y() + corner.x());
  };
  Sheet sheet;
  sheet.texts.push_back(
      {{first.x(), 12}, letter_mm, "Pizarra: ChArUco, 9 x 6 inner corners, squares of 25 mm, tags of 18 mm (4x4-50)"});
  for (int y = 0; y <= board.rows; ++y) {
    for (int x = y % 2; x <= board.columns; x += 2) {
      const Vector2d at = on_page(board.square_mm * Vector2d(x, y), board.square_mm);
      sheet.areas.push_back(box_at(at, Vector2d::Constant(board.square_mm)));
    }
  }
  const vision::TagFamily& family = *vision::family_called(kind.family);
  for (const camera::PlacedTag& tag : camera::tags_on(board)) {
    cv::Mat turned;
    cv::rotate(vision::print_of(family, tag.number), turned, cv::ROTATE_90_CLOCKWISE);
    const Vector2d at = on_page({tag.corner_mm.x, tag.corner_mm.y}, kind.side_mm);
    add_tag(sheet, turned, at, kind.side_mm / turned.cols);
  }
  add_scale(sheet);
  return sheet;
}

}  // namespace pizarra::programs
