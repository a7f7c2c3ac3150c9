#include "agents/vision/sight/body_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>
#include <opencv2/core/eigen.hpp>

#include "agents/vision/sight/plane_solve.hpp"

namespace pizarra::vision {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// How well it is known where a mark was glued to its body: standard deviations.
constexpr double glued_mm = 0.3;
constexpr double glued_rad = 0.3 * std::numbers::pi / 180;
// Of six squared errors in standard deviations: noise makes as many once in a million looks.
constexpr double most_apart = 40;
constexpr int steps = 5;

Eigen::Vector3d eigen_of(const cv::Vec3d& v) { return {v[0], v[1], v[2]}; }

Eigen::Matrix3d eigen_of(const cv::Matx33d& m) {
  Eigen::Matrix3d out;
  cv::cv2eigen(m, out);
  return out;
}

// The product with it is the cross product with `v`.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

Eigen::Vector3d as_small_turn(const Eigen::Matrix3d& turn) {
  const Eigen::AngleAxisd about(turn);
  return about.angle() * about.axis();
}

struct Rigid {
  Eigen::Matrix3d turn;
  Eigen::Vector3d place;
};

struct Measured {
  const MarkOnBody* mark;
  Rigid on_body;
  Rigid seen;
  Matrix6 covariance;

  // Where the body is by this mark alone.
  Rigid body() const {
    const Eigen::Matrix3d turn = seen.turn * on_body.turn.transpose();
    return {turn, seen.place - turn * on_body.place};
  }
  // What was measured less what the body's pose lets expect.
  Vector6 off(const Rigid& body) const {
    Vector6 out;
    out.head<3>() = seen.place - (body.place + body.turn * on_body.place);
    out.tail<3>() = as_small_turn(seen.turn * (body.turn * on_body.turn).transpose());
    return out;
  }
  // How the expected pose of the mark changes with a shift of the body and a small turn about its zero.
  Matrix6 slope(const Rigid& body) const {
    Matrix6 out = Matrix6::Identity();
    out.topRightCorner<3, 3>() = -cross_matrix(body.turn * on_body.place);
    return out;
  }
};

Measured measured(const MarkInSight& seen) {
  Matrix6 covariance = seen.pose.covariance;
  covariance.topLeftCorner<3, 3>() += glued_mm * glued_mm * Eigen::Matrix3d::Identity();
  covariance.bottomRightCorner<3, 3>() += glued_rad * glued_rad * Eigen::Matrix3d::Identity();
  return {seen.mark,
          {eigen_of(seen.mark->turn), eigen_of(seen.mark->place_mm)},
          {eigen_of(seen.pose.turn), eigen_of(seen.pose.place_mm)},
          covariance};
}

// Whether both may be marks of one body, as far as either is known.
bool agree(const Measured& a, const Measured& b) {
  const Rigid body = a.body();
  const Matrix6 to_b = b.slope(body) * a.slope(body).inverse();
  const Matrix6 apart = b.covariance + to_b * a.covariance * to_b.transpose();
  const Vector6 off = b.off(body);
  return off.dot(apart.ldlt().solve(off)) < most_apart;
}

// The most that agree with one of them; of as many those around the one that is known best.
std::vector<Measured> agreeing(const std::vector<Measured>& all) {
  std::vector<Measured> best;
  double best_spread = 0;
  for (const Measured& one : all) {
    std::vector<Measured> group;
    for (const Measured& other : all) {
      if (other.mark == one.mark || agree(one, other)) group.push_back(other);
    }
    const double spread = one.covariance.topLeftCorner<3, 3>().trace();
    const bool better = group.size() > best.size() || (group.size() == best.size() && spread < best_spread);
    if (!better) continue;
    best = std::move(group);
    best_spread = spread;
  }
  return best;
}

}  // namespace

const MarkOnBody* Body::mark(std::string_view called) const {
  const auto found = std::ranges::find_if(marks, [&](const MarkOnBody& mark) { return same_name(mark.name, called); });
  return found == marks.end() ? nullptr : &*found;
}

std::optional<BodyPose> body_pose(std::span<const MarkInSight> seen) {
  if (seen.empty()) return std::nullopt;
  std::vector<Measured> all;
  for (const MarkInSight& one : seen) all.push_back(measured(one));
  const std::vector<Measured> used = agreeing(all);
  Rigid body = used.front().body();
  Matrix6 information = Matrix6::Zero();
  for (int step = 0; step < steps; ++step) {
    information.setZero();
    Vector6 pull = Vector6::Zero();
    for (const Measured& one : used) {
      const Matrix6 slope = one.slope(body);
      const Matrix6 weighted = slope.transpose() * one.covariance.inverse();
      information += weighted * slope;
      pull += weighted * one.off(body);
    }
    const Vector6 by = information.ldlt().solve(pull);
    body.place += by.head<3>();
    const Eigen::Vector3d turn = by.tail<3>();
    if (turn.norm() > 0) body.turn = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * body.turn;
  }
  BodyPose out{{{body.place.x(), body.place.y(), body.place.z()}, matx_of(body.turn), information.inverse()}, {}};
  for (const Measured& one : used) out.by.push_back(one.mark->name);
  return out;
}

}  // namespace pizarra::vision
