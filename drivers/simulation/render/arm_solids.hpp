#pragma once

// An arm as solids to draw: turret, links and joints, up to the flange, and the pedestal that it stands on.
//
//   add_pedestal(solids, arm, Eigen::Vector3d::Zero());
//   add_arm(solids, arm, joints);

#include "drivers/arm/kinematics.hpp"
#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

// The solid under axis 1, `foot` being where axis 1 meets the table, mm. A gantry has none.
void add_pedestal(std::vector<Solid>& solids, const arm::ArmModel& arm, const Eigen::Vector3d& foot);
// All that moves with the arm's axes, up to the flange; the pedestal too, where a track carries it.
void add_arm(std::vector<Solid>& solids, const arm::ArmModel& arm, const arm::Joints& joints);

}  // namespace pizarra::simulation
