#include "programs/commands/print_sheet.hpp"

#include "drivers/simulation/render/solid.hpp"

namespace pizarra::programs {
namespace {

using Eigen::Vector2d;

constexpr double face_mm = simulation::marked_cube_mm;
constexpr double text_mm = 4;

std::vector<Vector2d> box(double left, double top, double width, double height) {
  return box_at({left, top}, {width, height});
}

void add_mark(Sheet& sheet, simulation::Mark mark, const Vector2d& centre) {
  for (const simulation::Polygon& part : simulation::mark_shape(mark)) {
    std::vector<Vector2d>& area = sheet.areas.emplace_back();
    for (const Vector2d& point : part) area.emplace_back(centre + Vector2d(point.x(), -point.y()));
  }
}

// Two strokes a corner, outside of the face: what is cut out shows none of them.
void add_cut_marks(Sheet& sheet, const Vector2d& centre) {
  constexpr double length = 5;
  constexpr double gap = 1;
  constexpr double stroke = 0.2;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vector2d corner = centre + face_mm / 2 * Vector2d(x, y);
      const double beside = x > 0 ? corner.x() + gap : corner.x() - gap - length;
      const double above = y > 0 ? corner.y() + gap : corner.y() - gap - length;
      sheet.areas.push_back(box(beside, corner.y() - stroke / 2, length, stroke));
      sheet.areas.push_back(box(corner.x() - stroke / 2, above, stroke, length));
    }
  }
}

}  // namespace

std::vector<Vector2d> box_at(const Vector2d& corner, const Vector2d& size) {
  return {corner, corner + Vector2d(size.x(), 0), corner + size, corner + Vector2d(0, size.y())};
}

void add_scale(Sheet& sheet) {
  constexpr double top = 284;
  constexpr double length = 100;
  const double left = (Sheet::width_mm - length) / 2;
  sheet.areas.push_back(box(left, top, length, 0.5));
  for (int i = 0; i <= 10; ++i) {
    const double height = i % 5 == 0 ? 3 : 1.5;
    const double stroke = 0.3;
    const double x = left + 10 * i - (i == 0 ? 0 : i == 10 ? stroke : stroke / 2);
    sheet.areas.push_back(box(x, top - height, stroke, height));
  }
  sheet.texts.push_back({{left, top + 1.5 * text_mm}, text_mm, "100 mm, when printed at 100 %"});
}

Sheet shapes_sheet() {
  constexpr simulation::Mark marks[] = {simulation::Mark::circle, simulation::Mark::triangle, simulation::Mark::square,
                                        simulation::Mark::cross};
  Sheet sheet;
  sheet.texts.push_back({{20, 14}, text_mm, "Pizarra: four shapes to learn, each a face for a cube of 60 mm"});
  for (int i = 0; i < 4; ++i) {
    const Vector2d face(60 + 90 * (i % 2), 85 + 110 * (i / 2));
    add_mark(sheet, marks[i], face);
    add_cut_marks(sheet, face);
  }
  add_scale(sheet);
  return sheet;
}

Sheet board_sheet() {
  constexpr int columns = 7;
  constexpr int rows = 10;
  constexpr double square_mm = 25;
  const double left = (Sheet::width_mm - columns * square_mm) / 2;
  constexpr double top = 16;
  Sheet sheet;
  sheet.texts.push_back(
      {{left, 12}, text_mm, "Pizarra: 9 x 6 inner corners, squares of 25 mm; glue it on something flat"});
  for (int y = 0; y < rows; ++y) {
    for (int x = y % 2; x < columns; x += 2) {
      sheet.areas.push_back(box(left + x * square_mm, top + y * square_mm, square_mm, square_mm));
    }
  }
  add_scale(sheet);
  return sheet;
}

}  // namespace pizarra::programs
