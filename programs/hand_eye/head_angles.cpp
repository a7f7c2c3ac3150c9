#include "programs/hand_eye/head_angles.hpp"

#include <cmath>

#include "programs/hand_eye/spread_out.hpp"

namespace pizarra::hand_eye {

namespace {

constexpr double grid_deg = 2;
constexpr double most_pan_deg = 40;
constexpr double most_tilt_deg = 30;
constexpr double least_turn_deg = 4;

double turned_apart(ptu::HeadTurn one, ptu::HeadTurn other) {
  return std::hypot(one.pan_deg - other.pan_deg, one.tilt_deg - other.tilt_deg);
}

bool reaches(const ptu::PanTiltAxisRange& axis, double deg) { return axis.low_deg <= deg && deg <= axis.high_deg; }

}  // namespace

std::vector<ptu::HeadTurn> angles_to_turn_to(const forms::CameraPose& pose, const coordinator::CameraModel& model,
                                             const Eigen::Vector3d& mark_mm, const ptu::PanTiltRange& range,
                                             double margin_mm, std::size_t wanted) {
  std::vector<ptu::HeadTurn> possible;
  for (double pan = -most_pan_deg; pan <= most_pan_deg; pan += grid_deg) {
    for (double tilt = -most_tilt_deg; tilt <= most_tilt_deg; tilt += grid_deg) {
      const ptu::HeadTurn turn{pan, tilt};
      const bool within =
          reaches(range.pan, pan) && reaches(range.tilt, tilt) && turned_apart(turn, {}) >= least_turn_deg;
      if (within && coordinator::CameraView(pose, model, turn).shows(mark_mm, margin_mm)) possible.push_back(turn);
    }
  }
  return spread_out(possible, wanted, turned_apart);
}

}  // namespace pizarra::hand_eye
