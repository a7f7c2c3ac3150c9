#include "programs/hand_eye/head_fit.hpp"

#include "agents/coordinator/geometry/mark_fit.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::hand_eye {

namespace {

// x, y, z, pan, tilt, roll, mark; of each axis how it leans in two directions, degrees, and where it passes a plane
// through the camera's centre: the pan axis x and z, the tilt axis y and z.
constexpr int unknowns = 17;
using Seventeen = coordinator::Numbers<unknowns>;
constexpr int pan_leaning = 9, pan_place = 11, tilt_leaning = 13, tilt_place = 15;
constexpr int across = 0, down = 1, ahead = 2;

const Seventeen unsure = [] {
  Seventeen out;
  out << Eigen::Vector3d::Constant(300), Eigen::Vector3d::Constant(15), Eigen::Vector3d::Constant(10),
      Eigen::Vector2d::Constant(10), Eigen::Vector2d::Constant(200), Eigen::Vector2d::Constant(10),
      Eigen::Vector2d::Constant(200);
  return out;
}();

// `main`: the direction along which it mostly is.
Eigen::Vector4d numbers_of(const forms::HeadAxis& axis, int main, int first, int second) {
  const Eigen::Vector3d at(axis.at_mm.data());
  const Eigen::Vector3d along(axis.along.data());
  const Eigen::Vector3d passes = at - along * (at[main] / along[main]);
  return {degrees(std::atan(along[first] / along[main])), degrees(std::atan(along[second] / along[main])),
          passes[first], passes[second]};
}

forms::HeadAxis axis_of(const Seventeen& numbers, int leaning, int place, int main, int first, int second) {
  Eigen::Vector3d along;
  along[main] = 1;
  along[first] = std::tan(radians(numbers[leaning]));
  along[second] = std::tan(radians(numbers[leaning + 1]));
  along.normalize();
  forms::HeadAxis axis{.along = {along.x(), along.y(), along.z()}};
  axis.at_mm[static_cast<std::size_t>(first)] = numbers[place];
  axis.at_mm[static_cast<std::size_t>(second)] = numbers[place + 1];
  return axis;
}

Seventeen numbers_of(const coordinator::MountedCamera& camera) {
  const forms::HeadAxes axes = ptu::axes_of(camera.pose);
  Seventeen out;
  out << camera.pose.at_mm[0], camera.pose.at_mm[1], camera.pose.at_mm[2], camera.pose.pan_deg, camera.pose.tilt_deg,
      camera.pose.roll_deg, camera.mark_mm, numbers_of(axes.pan, down, across, ahead),
      numbers_of(axes.tilt, across, down, ahead);
  return out;
}

coordinator::MountedCamera camera_of(const Seventeen& n) {
  const forms::HeadAxes axes{.pan = axis_of(n, pan_leaning, pan_place, down, across, ahead),
                             .tilt = axis_of(n, tilt_leaning, tilt_place, across, down, ahead)};
  return {.pose = {.at_mm = {n[0], n[1], n[2]}, .pan_deg = n[3], .tilt_deg = n[4], .roll_deg = n[5], .axes = axes},
          .mark_mm = n.segment<3>(6)};
}

}  // namespace

HeadFit fit_head(const coordinator::MountedCamera& guess, std::span<const coordinator::MarkPair> pairs,
                 const coordinator::CameraModel& model) {
  const auto expected = [&model](const Seventeen& numbers, const coordinator::MarkPair& pair) {
    return coordinator::expected_mark(camera_of(numbers), pair, model);
  };
  const auto fit = coordinator::fit_to_marks<unknowns>(numbers_of(guess), unsure, pairs, expected);
  const Seventeen deviations = fit.covariance.diagonal().cwiseSqrt();
  const auto largest = [&](int one, int other) {
    return std::max(deviations.segment<2>(one).maxCoeff(), deviations.segment<2>(other).maxCoeff());
  };
  return {.camera = camera_of(fit.numbers),
          .camera_mm = deviations.segment<3>(0).maxCoeff(),
          .camera_deg = deviations.segment<3>(3).maxCoeff(),
          .axes_mm = largest(pan_place, tilt_place),
          .axes_deg = largest(pan_leaning, tilt_leaning),
          .error_px = fit.error_px};
}

}  // namespace pizarra::hand_eye
