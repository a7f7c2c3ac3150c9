#pragma once

// How a controller interpolates a straight line of its tool: the waypoints, and the part of the axes' speeds at which
// they take as long as the line does at so many mm/s.
//
//   Result<StraightWay> way = straight_way(model, joints, pose, 100);
//   motion.begin(way->waypoints, way->part);

#include "drivers/arm/kinematics.hpp"

namespace pizarra::simulation {

struct StraightWay {
  std::vector<arm::Joints> waypoints;
  double part;  // 0..1
};

// From where the joints are to `to`, turning evenly. Failures: those of inverse(), at any point of the line.
Result<StraightWay> straight_way(const arm::ArmModel& model, const arm::Joints& from, const arm::ToolPose& to,
                                 double mm_s);

}  // namespace pizarra::simulation
