#include "agents/vision/marks/plane_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/image/levels.hpp"
#include "agents/vision/marks/edge_shifts.hpp"
#include "agents/vision/marks/robust.hpp"

namespace pizarra::vision {
namespace {

using Vector8 = Eigen::Matrix<double, 8, 1>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

// How far from where it is expected an edge is looked for: at first a part of the mark's standard deviation, px.
constexpr double first_reach = 0.4;
constexpr double least_reach_px = 2.5;
// An edge's change is added up so far to either side of its steepest place, while it is more than a part of that.
constexpr int spread_px = 5;
constexpr double least_share = 0.12;
constexpr double least_contrast = 10;  // grey levels
// The change at a place is that of the levels one pixel to either side, which makes it wider by this, px^2.
constexpr double variance_of_change = 1.0 / 3;
// Nearer to a corner than this blur bends a border: the image's, px, and the template's, as a part of the mark's
// standard deviation.
constexpr double corner_px = 2.5;
constexpr double corner_share = 0.25;
// Perspective: by how much of itself a mark grows over one standard deviation of it.
constexpr double usual_perspective = 0.03;
// Of an edge, px: at least so much.
constexpr double least_edge_spread = 0.08;
// Edges farther off support nothing: px, and a part of the mark's standard deviation. So far off they do not speak
// against it either where the template rounds a corner that is sharp.
constexpr double most_off_px = 0.75;
constexpr double most_off_share = 0.04;
constexpr double most_off_share_rounded = 0.1;

bool is_within(const cv::Mat1b& image, double x, double y) {
  return x >= 0 && y >= 0 && x < image.cols - 1 && y < image.rows - 1;
}

// The grey levels along a normal.
class Profile {
 public:
  static constexpr int longest = 2 * (for_whole.most_reach_px + spread_px) + 3;
  Profile(const cv::Mat1b& image, cv::Point2d at, const cv::Vec2d& normal, int reach, double sign)
      : reach_(reach), sign_(sign) {
    const int all = reach + spread_px + 1;
    const auto end = [&](int t) { return is_within(image, at.x + t * normal[0], at.y + t * normal[1]); };
    while (reach_ > 0 && !(end(-all + reach - reach_) && end(all - reach + reach_))) --reach_;
    if (reach_ == 0) return;
    half_ = reach_ + spread_px + 1;
    for (int t = -half_; t <= half_; ++t) {
      levels_[index(t)] = level_between(image, {at.x + t * normal[0], at.y + t * normal[1]});
    }
  }
  // Of the edge nearest and steepest; nothing where there is none.
  bool find(PlaneEdge& edge, double& width_px2) const {
    if (reach_ == 0) return false;
    int best = 0;
    double most = 0;
    for (int t = -reach_; t <= reach_; ++t) {
      const double far = static_cast<double>(t) / (reach_ + 1);
      const double steep = change(t) * (1 - far * far / 2);
      if (steep > most) {
        most = steep;
        best = t;
      }
    }
    if (most <= 0) return false;
    const double least = least_share * change(best);
    int low = best;
    int high = best;
    while (low > best - spread_px && low > -half_ + 1 && change(low - 1) > least) --low;
    while (high < best + spread_px && high < half_ - 1 && change(high + 1) > least) ++high;
    double sum = 0;
    double moment = 0;
    double second = 0;
    for (int t = low; t <= high; ++t) {
      sum += change(t);
      moment += change(t) * t;
      second += change(t) * t * t;
    }
    edge.off_px = moment / sum;
    width_px2 = second / sum - edge.off_px * edge.off_px - variance_of_change;
    edge.inner = level(std::max(low - 1, -half_));
    edge.outer = level(std::min(high + 1, half_));
    return sign_ * (edge.outer - edge.inner) >= least_contrast;
  }

 private:
  std::size_t index(int t) const {
    const int place = t + half_;
    return static_cast<std::size_t>(place);
  }
  double level(int t) const { return levels_[index(t)]; }
  double change(int t) const { return sign_ * (level(t + 1) - level(t - 1)) / 2; }
  int reach_;
  double sign_;
  int half_ = 0;
  std::array<double, longest> levels_{};
};

class Registration {
 public:
  Registration(const cv::Mat1b& image, const PlaneOutline& outline, const cv::Matx33d& start, MarkTone tone,
               const PlaneSearch& search, const PlaneLens& lens)
      : image_(image), outline_(outline), search_(search), lens_(lens), sign_(tone == MarkTone::dark ? 1 : -1) {
    fit_.to_image = (1 / start(2, 2)) * start;
    size_px_ = fit_.size_px();
    fit_.edges.resize((outline.points.size() + search.every - 1) / search.every);
    widths_px2_.resize(fit_.edges.size());
  }

  // Elsewhere nothing is asked of the outline.
  void go_by_border_of(const PlaneFit& fit) {
    for (const PlaneEdge& edge : fit.edges) shows_.push_back(edge.is_border);
  }
  bool run() {
    for (int step = 0; step < search_.steps; ++step) {
      const double reach = std::max(least_reach_px, first_reach * size_px_ * std::pow(0.5, step));
      if (!measure(std::min(search_.most_reach_px, cvCeil(reach)))) return false;
      if (!solve(step)) return false;
    }
    return judge();
  }
  PlaneFit take() { return std::move(fit_); }

 private:
  bool measure(int reach) {
    std::size_t found = 0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < fit_.edges.size(); ++i) {
      const PlaneOutline::Point& point = outline_.points[i * search_.every];
      PlaneEdge& edge = fit_.edges[i];
      const cv::Matx22d slope = fit_.slope_at(point.at);
      // A normal goes with the inverse transpose.
      cv::Vec2d normal = slope.inv().t() * point.out;
      const double length = cv::norm(normal);
      if (!(length > 0) || !std::isfinite(length)) return false;
      normal *= 1 / length;
      const cv::Point2d at = fit_.in_image(point.at);
      edge = PlaneEdge();
      edge.point = i * search_.every;
      edge.normal = normal;
      const double bent = std::max(corner_share, corner_px / size_px_);
      edge.counts = point.from_corner > bent;
      edge.measures = edge.counts && (shows_.empty() || shows_[i]);
      edge.found = Profile(image_, at, normal, reach, sign_).find(edge, widths_px2_[i]);
      edge.at = at + edge.off_px * cv::Point2d(normal[0], normal[1]);
      if (!edge.measures) continue;
      ++counted;
      found += edge.found ? 1 : 0;
    }
    return counted * search_.every >= 16 &&
           static_cast<double>(found) >= search_.least_found * static_cast<double>(counted);
  }

  // A robust standard deviation of the edges.
  double spread() const {
    std::vector<double> off;
    for (const PlaneEdge& edge : fit_.edges) {
      if (edge.found && edge.measures) off.push_back(std::abs(edge.off_px));
    }
    if (off.empty()) return least_edge_spread;
    std::ranges::nth_element(off, off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2));
    return std::max(least_edge_spread, 1.48 * off[off.size() / 2]);
  }

  bool solve(int step) {
    const double scale = spread();
    Matrix8 a = Matrix8::Zero();
    Vector8 b = Vector8::Zero();
    const cv::Matx33d& h = fit_.to_image;
    for (const PlaneEdge& edge : fit_.edges) {
      if (!edge.found || !edge.measures) continue;
      const cv::Vec2d& p = outline_.points[edge.point].at;
      const cv::Point2d x = fit_.in_image(p);
      const double w = h(2, 0) * p[0] + h(2, 1) * p[1] + 1;
      const double nx = edge.normal[0] / w;
      const double ny = edge.normal[1] / w;
      const double along = nx * x.x + ny * x.y;
      Vector8 j;
      j << nx * p[0], nx * p[1], nx, ny * p[0], ny * p[1], ny, -along * p[0], -along * p[1];
      const double weight = tukey_weight(edge.off_px, scale) / (scale * scale);
      a += weight * j * j.transpose();
      b += weight * edge.off_px * j;
    }
    // Perspective once the place is about right.
    const bool free_already = step > 0 || search_.knows_perspective;
    const double free = free_already ? usual_perspective : usual_perspective / 100;
    const double prior = 1 / (free * free);
    a(6, 6) += prior;
    a(7, 7) += prior;
    b(6) -= prior * h(2, 0);
    b(7) -= prior * h(2, 1);
    hold_slant(a, b);
    hold_rigid(a, b, h, lens_);
    normal_ = a;
    // Unknowns that the outline leaves open, such as a circle's turn, stay as they are.
    a.diagonal().head<6>().array() += 1e-4 * a.diagonal().head<6>().maxCoeff();
    const Vector8 d = a.ldlt().solve(b);
    if (!d.allFinite()) return false;
    for (int i = 0; i < 8; ++i) fit_.to_image.val[i] += d[i];
    const double size = fit_.size_px();
    if (!(size > size_px_ / 2) || !(size < 2 * size_px_)) return false;
    size_px_ = size;
    return true;
  }

  // A turn and a size leave the two columns of the slope as long, and at a right angle.
  void hold_slant(Matrix8& a, Vector8& b) const {
    if (!std::isfinite(search_.usual_slant)) return;
    const double free = search_.usual_slant * size_px_;
    const cv::Matx33d& h = fit_.to_image;
    const auto hold = [&](int one, int other, double sign, double off) {
      Vector8 j = Vector8::Zero();
      j[one] = 1;
      j[other] = sign;
      a += j * j.transpose() / (free * free);
      b -= j * off / (free * free);
    };
    hold(0, 4, -1, h(0, 0) - h(1, 1));
    hold(1, 3, 1, h(0, 1) + h(1, 0));
  }

  bool judge() {
    if (!measure(cvCeil(least_reach_px))) return false;
    const double most = std::max({most_off_px, most_off_share * size_px_, 3 * spread()});
    const double most_if_rounded = std::max(most, most_off_share_rounded * size_px_);
    double squares = 0;
    int counted = 0;
    int supporting = 0;
    for (PlaneEdge& edge : fit_.edges) {
      if (!edge.counts) continue;
      const double off = std::abs(edge.off_px);
      edge.is_border = edge.found && off < most;
      const bool is_rounded = edge.found && outline_.points[edge.point].is_rounded() && off < most_if_rounded;
      counted += edge.is_border || !is_rounded ? 1 : 0;
      if (!edge.is_border) continue;
      ++supporting;
      squares += edge.off_px * edge.off_px;
    }
    if (supporting == 0) return false;
    fit_.rms_px = std::sqrt(squares / supporting);
    fit_.middle_spread_px = middle_spread_px();
    fit_.supported = static_cast<double>(supporting) / counted;
    note_shifts(outline_, widths_px2_, fit_);
    return true;
  }

  // The longer one of the ellipse's. Neighbouring edges share pixels, so that two say as much as one.
  double middle_spread_px() const {
    Matrix8 normal = normal_;
    normal.diagonal() *= 1 + 1e-9;
    const Matrix8 covariance = normal.inverse();
    const double mean = (covariance(2, 2) + covariance(5, 5)) / 2;
    const double half = std::hypot((covariance(2, 2) - covariance(5, 5)) / 2, covariance(2, 5));
    return std::sqrt(2 * (mean + half));
  }

  const cv::Mat1b& image_;
  const PlaneOutline& outline_;
  const PlaneSearch search_;
  const PlaneLens lens_;
  const double sign_;  // 1 where the ground is lighter
  double size_px_;
  std::vector<double> widths_px2_;  // of the edges' changes: variances
  std::vector<bool> shows_;         // the border, by the outline's points; empty: all may
  Matrix8 normal_ = Matrix8::Identity();
  PlaneFit fit_;
};

}  // namespace

cv::Point2d PlaneFit::in_image(const cv::Vec2d& p) const {
  const cv::Matx33d& h = to_image;
  const double w = h(2, 0) * p[0] + h(2, 1) * p[1] + h(2, 2);
  return {(h(0, 0) * p[0] + h(0, 1) * p[1] + h(0, 2)) / w, (h(1, 0) * p[0] + h(1, 1) * p[1] + h(1, 2)) / w};
}

cv::Matx22d PlaneFit::slope_at(const cv::Vec2d& p) const {
  const cv::Matx33d& h = to_image;
  const double w = h(2, 0) * p[0] + h(2, 1) * p[1] + h(2, 2);
  const cv::Point2d x = in_image(p);
  return {(h(0, 0) - x.x * h(2, 0)) / w, (h(0, 1) - x.x * h(2, 1)) / w, (h(1, 0) - x.y * h(2, 0)) / w,
          (h(1, 1) - x.y * h(2, 1)) / w};
}

cv::Matx33d affine_start(const Reach& seen, const Reach& learned, int turn) {
  const double angle = 2 * std::numbers::pi * turn / Reach::turns;
  const cv::Matx22d turned(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
  const cv::Matx22d linear = seen.spread * turned * learned.spread.inv();
  const cv::Vec2d from = linear * cv::Vec2d(learned.middle.x, learned.middle.y);
  return {linear(0, 0),
          linear(0, 1),
          seen.middle.x - from[0],
          linear(1, 0),
          linear(1, 1),
          seen.middle.y - from[1],
          0,
          0,
          1};
}

std::optional<PlaneFit> fit_plane(const cv::Mat1b& image, const PlaneOutline& outline, const cv::Matx33d& start,
                                  MarkTone tone, const PlaneSearch& search, const PlaneLens& lens) {
  if (outline.points.size() < 32) return std::nullopt;
  Registration registration(image, outline, start, tone, search, lens);
  if (!registration.run()) return std::nullopt;
  return registration.take();
}

std::optional<PlaneFit> fit_to_border(const cv::Mat1b& image, const PlaneOutline& outline, const PlaneFit& fit,
                                      MarkTone tone, const PlaneSearch& search, const PlaneLens& lens) {
  Registration registration(image, outline, fit.to_image, tone, search, lens);
  registration.go_by_border_of(fit);
  if (!registration.run()) return std::nullopt;
  return registration.take();
}

}  // namespace pizarra::vision
