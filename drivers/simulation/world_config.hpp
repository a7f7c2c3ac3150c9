#pragma once

// The parts of a simulated cell: plain values, filled from a cell file, checked once, then given to the World. Base
// frame: x forward, y left of the arm, z up, origin on the table under axis 1. Lengths mm, angles degrees.
//
//   WorldConfig config;
//   config.cubes = {{.name = "circle", .mark = Mark::circle, .x_mm = 450, .y_mm = -100},
//                   {.name = "cross", .mark = Mark::cross, .on = "circle"}};
//   Result<void> sound = check(config);

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/arm/arm_file.hpp"
#include "drivers/camera/stereo_camera.hpp"
#include "drivers/ptu/head_axes.hpp"
#include "drivers/simulation/body_shape.hpp"
#include "drivers/simulation/face_mark.hpp"
#include "drivers/simulation/photograph.hpp"
#include "lisp/forms/camera_pose.hpp"
#include "lisp/result.hpp"

namespace pizarra::simulation {

inline constexpr double cube_mass_kg = 0.15;  // whatever its size
// Cubes in a world at once, the hand's included.
inline constexpr std::size_t max_cubes = 16;
inline constexpr std::size_t max_things = 16;
// The gripper's widest opening between the fingers.
inline constexpr double gripper_opening_mm = 100;

struct CubeConfig {
  std::string name;              // [A-Za-z][A-Za-z0-9-]*, told apart without case
  FaceMark mark = Mark::circle;  // on each face that bears no other
  double x_mm = 450;
  double y_mm = 0;
  double yaw_deg = 0;
  std::string on = "";                 // the cube that it stands on, listed before; empty: the table, at x, y
  std::optional<double> edge_mm = {};  // none: as large as the cell's cubes are
  CubeMarks faces = {};                // those of their own
  CubeMarks marks() const;
};

// A plain brick or cylinder on the table, which the eyes do not know.
struct ThingConfig {
  std::string name;
  BodyShape shape;
  double x_mm = 0;
  double y_mm = 0;
  double yaw_deg = 0;
};

// A plate with its upper face at z = 0.
struct TableConfig {
  double x_low_mm = -250;
  double x_high_mm = 650;
  double y_low_mm = -350;
  double y_high_mm = 350;
  double thickness_mm = 25;
};

// As OpenCV has it: k1, k2, p1, p2, k3.
using LensDistortion = std::array<double, 5>;

struct CameraConfig {
  camera::StereoModel model;
  forms::CameraPose pose;
  ptu::HeadTurn turn;      // how its unit has turned it
  std::string head = "";   // the pan-tilt unit that it stands on, as find_ptu_model() knows it; empty: it stands still
  int frames_per_s = 10;   // each takes a whole number of the world's steps
  double noise_sigma = 3;  // grey levels, each pixel and frame on its own
  double blur_sigma_px = 0.7;    // the lens's
  LensDistortion lens{};         // of both; their images are bent by it
  double light_gradient = 0.12;  // how much brighter one edge of the image is than the other; direction by the seed
  bool bends() const { return lens != LensDistortion{}; }
};

// A lamp beside the one high above the cell, with hard shadows.
struct LampConfig {
  std::array<double, 3> at_mm{};
  double part = 0.4;  // of the light that it gives, 0..1
};

struct WorldConfig {
  std::uint64_t seed = 1;
  TableConfig table;
  CameraConfig camera;
  std::optional<LampConfig> second_lamp = {};
  std::shared_ptr<const Photograph> background = nullptr;     // upright behind the table; none: a plain wall
  std::shared_ptr<const Photograph> table_picture = nullptr;  // over the table; none: plain, with lines
  double cube_mm = 60;  // the edge of a cube of which nothing else is said; its marks grow with it
  std::vector<CubeConfig> cubes;
  std::vector<ThingConfig> things;
  double edge_mm(const CubeConfig& cube) const { return cube.edge_mm.value_or(cube_mm); }
  arm::ArmModel arm = arm::crs_f3();
  std::optional<arm::ArmModel> second_arm;
  std::optional<arm::Joints> start_joints;  // the arm's ready pose where not given
};

// Failures, symbol bad-cell: bad or repeated names, unknown `on`, two cubes in one place, a cube off the table, figures
// of camera, lens, lamp, cubes or things out of range, too many cubes or things.
Result<void> check(const WorldConfig& config);

}  // namespace pizarra::simulation
