#pragma once

// The arm of a cell with the line to its controller: the simulated one's where the cell names no other; and with the
// gripper that the cell puts onto it.
//
//   const std::unique_ptr<CellArm> device = make_cell_arm(executor, description.arm_line, model, link);
//   RobotAgent robot(context, device->driver(), model);

#include <memory>

#include "drivers/arm/arm_driver.hpp"
#include "drivers/simulation/link.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra {
class Executor;
}

namespace pizarra::launcher {

class CellArm {
 public:
  virtual ~CellArm() = default;
  virtual arm::ArmDriver& driver() = 0;
};

// Executor and link outlive it. `simulated` is the device of the world that a line without a protocol leads to.
std::unique_ptr<CellArm> make_cell_arm(Executor& executor, const forms::ArmLine& line, const arm::ArmModel& model,
                                       simulation::Link& link, std::string_view simulated = "arm");

}  // namespace pizarra::launcher
