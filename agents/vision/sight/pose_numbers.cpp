#include "agents/vision/sight/pose_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pizarra::vision {
namespace {

constexpr double degrees_a_rad = 180 / std::numbers::pi;

}  // namespace

cv::Vec3d angles_deg(const cv::Matx33d& r) {
  return degrees_a_rad * cv::Vec3d(std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
                                   std::atan2(r(1, 0), r(0, 0)));
}

std::array<double, 6> spreads_of(const MarkPose& pose) {
  std::array<double, 6> out{};
  for (int i = 0; i < 6; ++i) {
    out[static_cast<std::size_t>(i)] = std::sqrt(pose.covariance(i, i)) * (i < 3 ? 1 : degrees_a_rad);
  }
  return out;
}

}  // namespace pizarra::vision
