#include "drivers/simulation/world_config.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>

#include "drivers/arm/kinematics.hpp"
#include "drivers/simulation/camera_lens.hpp"
#include "drivers/simulation/controllers/ptu_model.hpp"
#include "drivers/simulation/frame_clock.hpp"
#include "lisp/plain_name.hpp"
#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

namespace {

constexpr double narrowest_view_px = 16;
constexpr double widest_view_px = 4096;
constexpr double least_thing_mm = 10;
constexpr double most_thing_mm = 150;  // a carried cube passes above it

std::unexpected<Failure> bad(std::string sentence, std::string_view name) {
  return fail("bad-cell", std::move(sentence), Datum::string(name));
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

Result<void> check_camera(const CameraConfig& camera) {
  const camera::StereoModel& model = camera.model;
  const bool size =
      within(model.width, narrowest_view_px, widest_view_px) && within(model.height, narrowest_view_px, widest_view_px);
  const bool lens = within(model.focal_px, 10, 1e5) && within(model.base_line_mm, 1, 1000);
  const bool place = std::ranges::all_of(camera.pose.at_mm, [](double mm) { return std::isfinite(mm); }) &&
                     within(camera.pose.pan_deg, -180, 180) && within(camera.pose.tilt_deg, -80, 80);
  const bool sensor =
      within(camera.noise_sigma, 0, 50) && within(camera.blur_sigma_px, 0, 2) && within(camera.light_gradient, 0, 1);
  if (!FrameClock::keeps(camera.frames_per_s)) {
    return bad(fmt::format("no frame is taken {} times a second", camera.frames_per_s), "camera");
  }
  if (!size || !lens || !place || !sensor) return bad("the camera's figures are out of range", "camera");
  if (camera.bends() && !shows_all_once(camera)) {
    return bad("such a lens shows a point twice, or bends the images too far", "camera");
  }
  return {};
}

bool is_sound(const LampConfig& lamp) {
  const auto placed = [](double mm) { return within(mm, -10'000, 10'000); };
  return std::ranges::all_of(lamp.at_mm, placed) && lamp.at_mm[2] > 0 && within(lamp.part, 0, 1);
}

Result<void> check_cube(const WorldConfig& config, std::size_t index) {
  const CubeConfig& cube = config.cubes[index];
  if (!is_plain_name(cube.name)) return bad(fmt::format("\"{}\" is no name for a cube", cube.name), cube.name);
  const auto earlier = std::span(config.cubes).first(index);
  const auto named = [&](std::string_view name) {
    return std::ranges::find(earlier, lowered(name), [](const CubeConfig& other) { return lowered(other.name); });
  };
  if (!within(config.edge_mm(cube), 10, gripper_opening_mm)) {
    return bad(fmt::format("no gripper takes a cube of the size of {}", cube.name), cube.name);
  }
  if (named(cube.name) != earlier.end()) return bad(fmt::format("two cubes are called {}", cube.name), cube.name);
  if (!cube.on.empty()) {
    if (named(cube.on) == earlier.end()) {
      return bad(fmt::format("{} stands on {}, which is not listed before it", cube.name, cube.on), cube.name);
    }
    const auto shared = std::ranges::find(earlier, lowered(cube.on), [](const CubeConfig& o) { return lowered(o.on); });
    if (shared != earlier.end()) {
      return bad(fmt::format("{} and {} stand on the same cube", shared->name, cube.name), cube.name);
    }
    return {};
  }
  const TableConfig& table = config.table;
  if (!within(cube.x_mm, table.x_low_mm, table.x_high_mm) || !within(cube.y_mm, table.y_low_mm, table.y_high_mm)) {
    return bad(fmt::format("{} does not stand on the table", cube.name), cube.name);
  }
  for (const CubeConfig& other : earlier) {
    if (!other.on.empty()) continue;
    // Cubes that stand square may touch; turned ones need their diagonals' room.
    const bool square = std::fmod(cube.yaw_deg, 90) == 0 && std::fmod(other.yaw_deg, 90) == 0;
    const double dx = std::abs(cube.x_mm - other.x_mm);
    const double dy = std::abs(cube.y_mm - other.y_mm);
    const double apart = square ? std::max(dx, dy) : std::hypot(dx, dy);
    const double touching_mm = (config.edge_mm(cube) + config.edge_mm(other)) / 2;
    if (apart < touching_mm * (square ? 1 : std::sqrt(2.0))) {
      return bad(fmt::format("{} and {} stand in one place", other.name, cube.name), cube.name);
    }
  }
  return {};
}

Result<void> check_thing(const WorldConfig& config, std::size_t index) {
  const ThingConfig& thing = config.things[index];
  if (!is_plain_name(thing.name)) return bad(fmt::format("\"{}\" is no name for a thing", thing.name), thing.name);
  const auto has_name = [&](const auto& other) { return lowered(other.name) == lowered(thing.name); };
  const bool is_taken = std::ranges::any_of(config.cubes, has_name) ||
                        std::ranges::any_of(std::span(config.things).first(index), has_name);
  if (is_taken) return bad(fmt::format("{} is called like another", thing.name), thing.name);
  const auto& size = thing.shape.size_mm;
  const bool sized = within(size.minCoeff(), least_thing_mm, most_thing_mm) && size.maxCoeff() <= most_thing_mm;
  if (!sized) return bad(fmt::format("no thing of this world is as large or as small as {}", thing.name), thing.name);
  const TableConfig& table = config.table;
  const bool stands =
      within(thing.x_mm, table.x_low_mm, table.x_high_mm) && within(thing.y_mm, table.y_low_mm, table.y_high_mm);
  if (!stands) return bad(fmt::format("{} does not stand on the table", thing.name), thing.name);
  return {};
}

}  // namespace

CubeMarks CubeConfig::marks() const {
  CubeMarks out = on_each_face(mark);
  for (std::size_t face = 0; face < out.size(); ++face) {
    if (faces[face]) out[face] = faces[face];
  }
  return out;
}

Result<void> check(const WorldConfig& config) {
  const TableConfig& table = config.table;
  if (!(table.x_low_mm < table.x_high_mm && table.y_low_mm < table.y_high_mm && table.thickness_mm > 0)) {
    return bad("the table has no extent", "table");
  }
  if (!config.camera.head.empty() && find_ptu_model(config.camera.head) == nullptr) {
    return bad(fmt::format("there is no pan-tilt unit {}", config.camera.head), "camera");
  }
  const Result<void> camera = check_camera(config.camera);
  if (!camera) return camera;
  if (config.second_lamp && !is_sound(*config.second_lamp)) return bad("no lamp stands or shines like that", "lamp");
  if (!within(config.cube_mm, 10, gripper_opening_mm)) return bad("no gripper takes cubes of that size", "cubes");
  if (config.cubes.size() > max_cubes) {
    return bad(fmt::format("a cell has at most {} cubes", max_cubes), "cubes");
  }
  for (std::size_t index = 0; index < config.cubes.size(); ++index) {
    const Result<void> sound = check_cube(config, index);
    if (!sound) return sound;
  }
  if (config.things.size() > max_things) {
    return bad(fmt::format("a cell has at most {} bricks and cylinders", max_things), "things");
  }
  for (std::size_t index = 0; index < config.things.size(); ++index) {
    const Result<void> sound = check_thing(config, index);
    if (!sound) return sound;
  }
  if (config.start_joints) return arm::check_limits(config.arm, *config.start_joints);
  return {};
}

}  // namespace pizarra::simulation
