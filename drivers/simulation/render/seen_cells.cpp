#include "drivers/simulation/render/seen_cells.hpp"

#include <Eigen/LU>
#include <cmath>

namespace pizarra::simulation {

namespace {

// A pixel is looked at in so many places each way.
constexpr int places = 4;

}  // namespace

SeenCells::SeenCells(const Eye& eye, const TagCells& cells)
    : print_(cells.print), to_cells_(eye.plane_to_pixels(cells.corner_mm, cells.right_mm, cells.down_mm).inverse()) {}

bool SeenCells::is_light(double x, double y) const {
  const Eigen::Vector3d at = to_cells_ * Eigen::Vector3d(x, y, 1);
  const double column = std::floor(at.x() / at.z());
  const double row = std::floor(at.y() / at.z());
  const bool inside = column >= 0 && row >= 0 && column < print_->side && row < print_->side;
  return inside && print_->is_light(static_cast<int>(column), static_cast<int>(row));
}

float SeenCells::light(int x, int y) const {
  const auto aside = [](int place) { return (place + 0.5) / places - 0.5; };
  int lights = 0;
  for (int i = 0; i < places; ++i) {
    for (int j = 0; j < places; ++j) lights += is_light(x + aside(i), y + aside(j)) ? 1 : 0;
  }
  return static_cast<float>(lights) / (places * places);
}

}  // namespace pizarra::simulation
