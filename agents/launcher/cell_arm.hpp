#pragma once

// The arm of a cell with the line to its controller: the simulated one's where the cell names no other; and with the
// gripper that the cell puts onto it.
//
//   Parts devices;
//   RobotAgent robot(context, add_cell_arm(devices, executor, description.arm_line, model, link), model);

#include "drivers/arm/arm_driver.hpp"
#include "drivers/simulation/link.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/parts.hpp"

namespace pizarra {
class Executor;
}

namespace pizarra::launcher {

// Executor and link outlive the parts. `simulated` is the device of the world that a line without a protocol leads to.
arm::ArmDriver& add_cell_arm(Parts& parts, Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model,
                             simulation::Link& link, std::string_view simulated = "arm");

}  // namespace pizarra::launcher
