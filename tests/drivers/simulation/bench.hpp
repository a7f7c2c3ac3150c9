#pragma once

// A cell in virtual time for tests: world, arm and eyes, and plain functions to work them.

#include <gtest/gtest.h>
#include <optional>
#include <string>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/kinematics.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/simulated_camera.hpp"
#include "drivers/simulation/world.hpp"
#include "tests/run_task.hpp"

namespace pizarra::simulation {

struct TruthOf {
  double x_mm = 0;
  double y_mm = 0;
  double z_mm = 0;
  double yaw_deg = 0;
  double tilt_deg = 0;
  std::string state;  // as text: "table", "(on circle)", ...
  double visible = 0;
};

class Bench {
 public:
  explicit Bench(WorldConfig config);

  VirtualExecutor executor;
  const WorldConfig config;
  World world;
  LocalLink link;
  SimulatedArm arm;
  SimulatedCamera eyes;

  // The request's answer, which must not fail.
  Datum ask(std::string_view request);
  // The failure's symbol, or "ok".
  std::string outcome(std::string_view request);
  TruthOf truth(std::string_view cube);
  // The facts of the truth, as text.
  std::string facts();
  // The next frame, never the same again.
  camera::StereoFrame frame(bool colour = false);

  // The joints for the tool straight down there, its plate towards the camera.
  arm::Joints tool_down(double x_mm, double y_mm, double z_mm) const;
  // Straight to there; true when it arrived.
  bool go(double x_mm, double y_mm, double z_mm, double speed = 0.3);
  // Moves the fingers and answers the measured opening.
  double grip(double opening_mm);
  // Grasps the cube at x, y with its centre at z, and lifts it to the travel height.
  void pick(double x_mm, double y_mm, double z_mm, std::optional<double> edge_mm = {});
  // Puts what is held down with its centre at z and backs off.
  void put(double x_mm, double y_mm, double z_mm);
  void wait(Duration duration) { executor.run_for(duration); }
  arm::ArmReading reading();

 private:
  arm::Joints at_;
  Time last_frame_ = {};
};

// Four cubes in a row, as a newcomer sees them.
WorldConfig four_cubes();

}  // namespace pizarra::simulation
