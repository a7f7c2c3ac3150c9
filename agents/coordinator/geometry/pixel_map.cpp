#include "agents/coordinator/geometry/pixel_map.hpp"

#include <Eigen/Dense>

#include "agents/coordinator/geometry/mark_fit.hpp"

namespace pizarra::coordinator {

std::optional<PixelMap> PixelMap::from(std::span<const MarkPair> pairs) {
  constexpr Eigen::Index least_pairs = 4;
  constexpr double least_way_mm = 10;  // in the direction in which they lie least apart
  const auto many = static_cast<Eigen::Index>(pairs.size());
  if (many < least_pairs) return std::nullopt;
  Eigen::MatrixX3d places(many, 3);
  Eigen::MatrixX2d pixels(many, 2);
  for (Eigen::Index i = 0; i < many; ++i) {
    const MarkPair& pair = pairs[static_cast<std::size_t>(i)];
    places.row(i) = pair.tool.translation().transpose();
    pixels.row(i) = pair.seen.head<2>().transpose();
  }
  places.rowwise() -= places.colwise().mean().eval();
  pixels.rowwise() -= pixels.colwise().mean().eval();
  const Eigen::Matrix3d scatter = places.transpose() * places;
  if (eigenvalues_of(scatter)[0] < least_way_mm * least_way_mm) return std::nullopt;
  const Eigen::Matrix<double, 3, 2> slopes = scatter.ldlt().solve(places.transpose() * pixels);
  return PixelMap(slopes.transpose());
}

// The tool moves along y and z alone, so that the depth stays.
Eigen::Vector3d PixelMap::way_for(const Eigen::Vector2d& error_px) const {
  const Eigen::Vector2d across = px_per_mm_.rightCols<2>().completeOrthogonalDecomposition().solve(error_px);
  return {0, across.x(), across.y()};
}

}  // namespace pizarra::coordinator
