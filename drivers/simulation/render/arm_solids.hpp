#pragma once

// The looks of an arm, whatever its build: a pedestal, its links and joints along its skeleton.

#include <vector>

#include "drivers/arm/kinematics.hpp"
#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

// The solid under axis 1, `foot_mm` being where axis 1 meets the table. A gantry has none.
void add_pedestal(std::vector<Solid>& solids, const arm::ArmModel& arm, const Eigen::Vector3d& foot_mm);

// All that moves with the arm's axes, up to the flange; the pedestal too, where a track carries it.
void add_arm(std::vector<Solid>& solids, const arm::ArmModel& arm, const arm::Joints& joints);

}  // namespace pizarra::simulation
