#pragma once

// Where on the table a held cube is laid down, so that the eyes see it and all that stands there.
//
//   const SpotChoice spots(options, domain, scene);
//   const std::optional<Eigen::Vector2d> spot = spots.for_held("square", stood);   // none: nothing is free
//
// It is asked only while the scene has a view of the camera.

#include <optional>
#include <string_view>
#include <vector>

#include "agents/coordinator/geometry/free_spot.hpp"
#include "agents/coordinator/perceive/scene.hpp"

namespace pizarra::coordinator {

class SpotChoice {
 public:
  SpotChoice(const CoordinatorOptions& options, const TaskDomain& domain, const Scene& scene)
      : options_(options), domain_(domain), scene_(scene) {}

  // `stood`: where the cube is taken away from, so that what it hides there shows.
  std::optional<Eigen::Vector2d> for_held(std::string_view held, const std::optional<Eigen::Vector2d>& stood) const;
  // The middles of the cubes that stand somewhere. `lost`: with those that are not seen any more, where they were.
  std::vector<Eigen::Vector3d> standing_but(std::string_view held, bool lost) const;
  // The front of a cube of this edge that is let go there.
  Eigen::Vector3d on_table(double x_mm, double y_mm, double edge_mm) const;

 private:
  struct Wish;

  std::optional<Eigen::Vector2d> spot_as(const Wish& wish, std::string_view held,
                                         const std::optional<Eigen::Vector2d>& stood) const;
  std::vector<Eigen::Vector3d> behind(const Eigen::Vector2d& stood) const;
  bool is_shown(const Eigen::Vector2d& spot) const;
  bool is_in_sight(const Eigen::Vector2d& spot, const std::vector<Eigen::Vector3d>& others) const;
  bool is_off_places(const Eigen::Vector2d& spot) const;
  TableArea area() const;
  double from_y_mm() const;

  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const Scene& scene_;
};

}  // namespace pizarra::coordinator
