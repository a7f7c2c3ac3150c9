#include "programs/chaos/draw_camera.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace pizarra::chaos {

namespace {

constexpr double off_mm = 20;
constexpr double off_deg = 2;

// Of this length. All directions are equally likely.
std::array<double, 3> any_way(double length, Random& random) {
  std::array<double, 3> offset{random.normal(), random.normal(), random.normal()};
  const double drawn = std::hypot(offset[0], offset[1], offset[2]);
  for (double& part : offset) part *= length / drawn;
  return offset;
}

std::string pose_text(const forms::CameraPose& pose) {
  return fmt::format("{:.1f} {:.1f} {:.1f} mm, pan {:.2f}, tilt {:.2f}, roll {:.2f}", pose.at_mm[0], pose.at_mm[1],
                     pose.at_mm[2], pose.pan_deg, pose.tilt_deg, pose.roll_deg);
}

}  // namespace

bool is_camera_guessed(const forms::CellDescription& cell) {
  return cell.camera.unknown || cell.camera.pose != cell.world_camera;
}

void guess_camera(forms::CellDescription& cell, Random random) {
  const bool is_measured = cell.camera.sure_mm < off_mm || cell.camera.sure_deg < off_deg;
  if (cell.camera.unknown || is_measured) return;
  const std::array<double, 3> off = any_way(off_mm, random);
  const std::array<double, 3> turned = any_way(off_deg, random);
  forms::CameraPose& pose = cell.camera.pose;
  pose = cell.world_camera;
  for (std::size_t axis = 0; axis < off.size(); ++axis) pose.at_mm[axis] += off[axis];
  pose.pan_deg += turned[0];
  pose.tilt_deg += turned[1];
  pose.roll_deg += turned[2];
}

void draw_head(forms::CellDescription& cell, Random random) {
  constexpr std::uint64_t one_in = 8;
  const bool has_one = !cell.head.empty() || !cell.pan_tilt.kind.empty();
  if (!has_one && random.below(one_in) == 0) cell.head = "ptu46-17.5";
}

void take_larger_images(forms::CellDescription& cell) {
  constexpr forms::CellImageSize larger{640, 480};
  if (cell.image.width_px < larger.width_px) cell.image = larger;
}

std::string describe_camera(const forms::CellDescription& cell) {
  const std::string stands = "camera at " + pose_text(cell.world_camera);
  if (cell.camera.unknown) return stands + "; nobody has measured it";
  if (!is_camera_guessed(cell)) return stands + ", as the agents know";
  return fmt::format("{}; taken to be at {}, sure to {} mm and {} degrees", stands, pose_text(cell.camera.pose),
                     cell.camera.sure_mm, cell.camera.sure_deg);
}

}  // namespace pizarra::chaos
