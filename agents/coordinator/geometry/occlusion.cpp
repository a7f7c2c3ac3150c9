#include "agents/coordinator/geometry/occlusion.hpp"

#include <cmath>

namespace pizarra::coordinator {

bool hidden_by_gripper(const CameraView& view, const GripperOutline& outline, const Eigen::Vector3d& grip,
                       const Eigen::Vector3d& mark) {
  const Sight gripper = view.sight(grip);
  const Sight object = view.sight(mark);
  // What is held stands in the gripper's own plane.
  if (object.depth_mm < gripper.depth_mm - outline.mark_half_mm) return false;
  const double px_per_mm = view.focal_px() / gripper.depth_mm;
  const double across_px = std::abs(object.x_px - gripper.x_px);
  const double below_px = object.y_px - gripper.y_px;
  return across_px < (outline.half_width_mm + outline.mark_half_mm) * px_per_mm &&
         below_px < (outline.below_mm + outline.mark_half_mm) * px_per_mm;
}

}  // namespace pizarra::coordinator
