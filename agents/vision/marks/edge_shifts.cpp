#include "agents/vision/marks/edge_shifts.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>
namespace pizarra::vision {
namespace {

// So far from an edge, and from where its change ends to either side, no other border may be, px; and no nearer than
// motion reaches that blurs as much. Nor may the template round it there.
constexpr double clear_px = 2.5;
constexpr double reach_of_motion = std::numbers::sqrt3;  // in standard deviations of its blur, either way
constexpr double half_change_px = 1.5;
// Edges that are so many times as far off as all are wide by something else than blur.
constexpr double stray = 2.5;
// How much blur in all directions alike counts, where few directions of edges say otherwise, for each edge.
constexpr double alike_share = 0.01;

// The blur's covariance, px^2.
class Blur {
 public:
  Blur(const std::vector<PlaneEdge>& edges, std::span<const double> widths_px2) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i].is_border && edges[i].counts) edges_.push_back({row(edges[i].normal), widths_px2[i]});
    }
    fit();
    double squares = 0;
    for (const Width& width : edges_) squares += off(width) * off(width);
    const double most = stray * std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, edges_.size())));
    std::erase_if(edges_, [&](const Width& width) { return std::abs(off(width)) > most; });
    fit();
  }
  double variance_along(const cv::Vec2d& direction) const { return std::max(0.0, row(direction).dot(covariance_)); }

 private:
  struct Width {
    Eigen::Vector3d by;
    double px2;
  };
  static Eigen::Vector3d row(const cv::Vec2d& n) { return {n[0] * n[0], 2 * n[0] * n[1], n[1] * n[1]}; }
  double off(const Width& width) const { return width.px2 - width.by.dot(covariance_); }
  void fit() {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Width& width : edges_) {
      normal += width.by * width.by.transpose();
      right += width.px2 * width.by;
    }
    const double alike = alike_share * static_cast<double>(std::max<std::size_t>(1, edges_.size()));
    const Eigen::Vector3d stretch(1, 0, -1);
    normal += alike * (stretch * stretch.transpose());
    normal(1, 1) += alike;
    covariance_ = normal.ldlt().solve(right);
    if (!covariance_.allFinite()) covariance_.setZero();
  }
  std::vector<Width> edges_;
  Eigen::Vector3d covariance_ = Eigen::Vector3d::Zero();  // xx, xy, yy
};

// From the nearest place of the ray.
cv::Vec2d way_from_ray(const cv::Point2d& to, const cv::Point2d& from, const cv::Vec2d& along) {
  const cv::Vec2d way(to.x - from.x, to.y - from.y);
  return way - std::max(0.0, way.dot(along)) * along;
}

bool is_clear(const cv::Vec2d& way, const Blur& blur) {
  const double length = cv::norm(way);
  if (length <= clear_px) return false;
  return length > reach_of_motion * std::sqrt(blur.variance_along(1 / length * way));
}

bool is_clear_of_bends(const PlaneFit& fit, const PlaneOutline::Point& point, const BendsAround& bends,
                       const cv::Vec2d& normal, const Blur& blur) {
  if (!bends.any) return true;
  if (point.is_rounded()) return false;
  const cv::Point2d place = fit.in_image(point.at);
  return std::ranges::all_of(bends.next, [&](const Bend& bend) {
    const cv::Point2d corner = fit.in_image(bend.at);
    const cv::Vec2d beyond = cv::normalize(fit.slope_at(bend.at) * bend.beyond);
    return std::ranges::all_of(std::array{-half_change_px, 0.0, half_change_px}, [&](double across) {
      const cv::Point2d there = place + across * cv::Point2d(normal[0], normal[1]);
      return is_clear(way_from_ray(there, corner, beyond), blur);
    });
  });
}

// How far blur moves an edge of an arc to its inside. A homography leaves straight what is: so the image's curvature is
// the plane's, by how it is enlarged there.
double bent_px(const PlaneFit& fit, const PlaneOutline::Point& point, double curvature, const cv::Vec2d& normal,
               const Blur& blur) {
  const cv::Matx22d slope = fit.slope_at(point.at);
  const double along = cv::norm(slope * cv::Vec2d(-point.out[1], point.out[0]));
  const double in_image = curvature * std::abs(cv::determinant(slope)) / (along * along * along);
  return in_image * blur.variance_along({-normal[1], normal[0]}) / 2;
}

}  // namespace

void note_shifts(const PlaneOutline& outline, std::span<const double> widths_px2, PlaneFit& fit) {
  const Blur blur(fit.edges, widths_px2);
  for (PlaneEdge& edge : fit.edges) {
    const PlaneOutline::Point& point = outline.points[edge.point];
    const BendsAround& bends = outline.bends[edge.point];
    edge.is_straight = is_clear_of_bends(fit, point, bends, edge.normal, blur);
    if (!edge.is_border || !edge.is_straight) continue;
    const double bent = bent_px(fit, point, bends.curvature, edge.normal, blur);
    edge.at += bent * cv::Point2d(edge.normal[0], edge.normal[1]);
  }
}

}  // namespace pizarra::vision
