#include "agents/vision/sight/plane_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "agents/vision/sight/plane_solve.hpp"

namespace pizarra::vision {
namespace {

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;
using Eigen::Vector2d;

// Of an edge, px, at least.
constexpr double least_edge_spread = 0.03;
// Neighbouring edges' errors correlate by at most this.
constexpr double most_in_common = 0.8;
// For weighing explanations against each other: the error, px, that averaging edges does not reduce (the pixels' phase,
// the lens, the template), and the part of the edges that count as independent.
constexpr double least_common_spread = 0.08;
constexpr double independent_share = 0.5;
// A homography has so many numbers; a pose fewer than so many edges say nothing of.
constexpr int free_numbers = 8;
constexpr std::size_t least_edges = 12;
// Of a mark's size that both images of a pair say anew, as a part of it.
constexpr double size_spread_of_pair = 0.01;
constexpr double least_stretch = 0.001;
// The same of a learned outline, whose own moments are a circle's. Explanations are not held to so little: a lens bends
// what it shows.
constexpr double stretch_of_outline = 0.0003;
// The edges away from bends alone say where the mark is, where they are so many of all.
constexpr double least_straight = 0.5;
// How far the pixels' phase moves a mark's middle, px. It moves all of a side alike, so that no scatter shows it.
constexpr double middle_phase_px = 0.015;
// Grey levels: from here on lighter ones look alike, but for noise and what a JPEG leaves of them.
constexpr double full_scale = 250;
// It cuts off up to 40 % of a clipped edge's change, one part as likely as another. The centroid of what is left of a
// Gaussian blur of 0.8 px lies so much nearer to the darker side: in the mean, by how much it differs from that, and by
// how much of it from one side of the mark to another.
constexpr double usual_pull_px = 0.2;
constexpr double pull_spread_px = 0.2;
constexpr double side_spread_px = 0.12;
// By how much worse another explanation must be.
constexpr double clearly_worse = 4;
// With so much more misfit than any homography a pose is none.
constexpr double least_contradiction = 4;
constexpr double clearly_contradicted = 15;
// How many looks at what is in no plane, or of another form, there are for each one that a pose explains about as well.
// A pair's evidence counts less: most of it comes from errors between its two images, and of the template.
constexpr double no_planes_for_one = 1e-6;
constexpr double share_of_both = 0.2;
// How far faces are turned from the axis of a camera that looks at them: a standard deviation.
constexpr double usual_turn_rad = 0.5;
// Of how far off a centre may be that is told surely, the wrong one of two tilts makes at most so much.
constexpr double share_of_tilt = 0.4;
// A tilt that is less likely is none.
constexpr double least_share_of_other = 0.01;

// A look whose six numbers are those of an affine map, but for what pulls clipped edges.
double affine_misfit(const std::vector<PlanePoint>& edges, const PlaneErrors& errors, double weight) {
  const double known = 1 / (errors.pull_spread_px * errors.pull_spread_px);
  Matrix7 normal = Matrix7::Zero();
  Vector7 right = Vector7::Zero();
  normal(6, 6) = known;
  right[6] = known * errors.usual_pull_px;
  double squares = right[6] * errors.usual_pull_px;
  for (const PlanePoint& edge : edges) {
    Vector7 j;
    j << edge.normal.x() * edge.plane, edge.normal.x(), edge.normal.y() * edge.plane, edge.normal.y(), edge.pulled;
    const double seen = edge.normal.dot(edge.seen);
    normal += weight * j * j.transpose();
    right += weight * j * seen;
    squares += weight * seen * seen;
  }
  return std::max(0.0, squares - right.dot(normal.ldlt().solve(right))) / 2;
}

// How the edges scatter about the outline, wherever that lies.
struct Scatter {
  double squares = 0;  // px
  double beside = 0;   // each times its neighbour
  int edges = 0;
  int numbers = 0;  // that were fitted

  double variance() const {
    return std::max(least_edge_spread * least_edge_spread, squares / std::max(1, edges - numbers));
  }
  // The inverse variance of an edge, counted as if each were off by itself. The errors of neighbours
  // correlate, less with each edge between them (a process of first order). The fit took away some of that: for each
  // number as much as one edge's.
  double weight() const {
    const double in_common = (beside + numbers * variance()) / (edges * variance());
    const double rho = std::clamp(in_common, 0.0, most_in_common);
    return (1 - rho) / (1 + rho) / variance();
  }
  double weight_of_explanations() const {
    return independent_share / std::max(least_common_spread * least_common_spread, squares / edges);
  }
};

bool is_clipped(const PlaneEdge& edge) { return std::max(edge.inner, edge.outer) >= full_scale; }

// The edges that a pose goes by.
class PoseEdges {
 public:
  enum class Which : std::uint8_t { all, straight };
  PoseEdges(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFace& face, Which which)
      : model_(model), outline_(outline), to_mm_(face.unit_mm * face.stretch), which_(which) {}

  // Of one image, whose camera stands so far to the right of the left one.
  void add(const PlaneFit& fit, double beside_mm) {
    scatter_.numbers += free_numbers;
    const PlaneEdge* before = nullptr;
    for (const PlaneEdge& edge : fit.edges) {
      const bool there = edge.counts && edge.is_border && (which_ == Which::all || edge.is_straight);
      if (there) add(edge, before, beside_mm);
      before = there ? &edge : nullptr;
    }
  }
  const std::vector<PlanePoint>& points() const { return points_; }
  bool are_enough_of(const PoseEdges& all) const {
    return static_cast<double>(points_.size()) >= least_straight * static_cast<double>(all.points_.size());
  }
  const Scatter& scatter() const { return scatter_; }

 private:
  void add(const PlaneEdge& edge, const PlaneEdge* before, double beside_mm) {
    scatter_.squares += edge.off_px * edge.off_px;
    if (before != nullptr) scatter_.beside += edge.off_px * before->off_px;
    ++scatter_.edges;
    const double darker = edge.inner < edge.outer ? -1 : 1;
    const cv::Vec2d p = to_mm_ * (outline_.points[edge.point].at - outline_.middle);
    points_.push_back(
        {Vector2d(p[0], p[1]),
         {(edge.at.x - model_.centre_x_px) / model_.focal_px, (edge.at.y - model_.centre_y_px) / model_.focal_px},
         Vector2d(edge.normal[0], edge.normal[1]) * model_.focal_px,
         beside_mm,
         is_clipped(edge) ? darker : 0,
         outline_.points[edge.point].side});
  }
  const camera::StereoModel& model_;
  const PlaneOutline& outline_;
  const cv::Matx22d to_mm_;
  const Which which_;
  std::vector<PlanePoint> points_;
  Scatter scatter_;
};

cv::Point2d in_image(const camera::StereoModel& model, const cv::Vec3d& place_mm) {
  return {model.centre_x_px + model.focal_px * place_mm[0] / place_mm[2],
          model.centre_y_px + model.focal_px * place_mm[1] / place_mm[2]};
}

// With those of the edges.
double unlikely(const PlaneTilt& tilt) { return tilt.misfit + unusual(tilt); }

PlaneErrors errors_of(const PoseEdges& edges, const PlaneFace& face, double stretch_at_least, bool by_both) {
  PlaneErrors out{.weight = edges.scatter().weight()};
  out.stretch_spread = std::max(stretch_at_least, face.stretch_spread);
  if (by_both) out.size_spread = size_spread_of_pair;
  out.usual_pull_px = usual_pull_px;
  out.pull_spread_px = pull_spread_px;
  out.side_spread_px = side_spread_px;
  return out;
}

PlaneTilt tilt_of(const camera::StereoModel& model, const SolvedPlane& solved, double misfit) {
  const Eigen::Vector3d& place = solved.pose.place;
  PlaneTilt out{{place.x(), place.y(), place.z()}, matx_of(solved.pose.turn), solved.covariance, misfit};
  const double phase_mm = middle_phase_px * place.norm() / model.focal_px;
  const Eigen::Vector3d sight = place.normalized();
  out.covariance.topLeftCorner<3, 3>() +=
      phase_mm * phase_mm * (Eigen::Matrix3d::Identity() - sight * sight.transpose());
  return out;
}

SolvedPlane refined(const SolvedPlane& by_all, const PoseEdges& best, const PlaneErrors& errors) {
  const std::vector<SolvedPlane> out = solve_plane(best.points(), std::span(&by_all.pose, 1), errors);
  return out.empty() ? by_all : out.front();
}

// Along the longer axis.
double longest_variance(const Eigen::Matrix2d& covariance) {
  const double half = covariance.trace() / 2;
  return half + std::sqrt(std::max(0.0, half * half - covariance.determinant()));
}

double off_if_hidden_px(const camera::StereoModel& model, const PoseEdges& edges, const PlaneErrors& errors,
                        const PlaneGuess& pose) {
  const Eigen::Vector3d& at = pose.place;
  Eigen::Matrix<double, 2, 3> in_image;
  in_image << 1, 0, -at.x() / at.z(), 0, 1, -at.y() / at.z();
  in_image *= model.focal_px / at.z();
  double most = 0;
  for (const PlaneMove& move : moves_without_sides(edges.points(), pose, errors)) {
    const Eigen::Matrix2d covariance = in_image * move.covariance * in_image.transpose();
    most = std::max(most, (in_image * move.by).squaredNorm() + longest_variance(covariance));
  }
  return std::sqrt(most);
}

// The likelier one first; nothing where the edges are no plane's.
std::vector<SolvedPlane> explained(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& left,
                                   const PoseEdges& edges, const PlaneFace& face, const PlaneErrors& errors,
                                   bool by_both) {
  const cv::Matx22d slope = left.slope_at(outline.middle) * (face.unit_mm * face.stretch).inv();
  const std::vector<PlaneGuess> guesses = plane_guesses(model, left.in_image(outline.middle), slope);
  // Two images tell the tilts apart: the first guess most often ends at the right one.
  std::vector<SolvedPlane> both;
  if (by_both && !guesses.empty()) {
    PlaneGuess first = guesses.front();
    if (face.turned_before)
      first.turn = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(face.turned_before->val);
    both = solve_plane(edges.points(), std::span(&first, 1), errors);
  }
  const double weight = edges.scatter().weight_of_explanations();
  const double free_misfit = weight * edges.scatter().squares / 2;
  const auto told = [&](const SolvedPlane& plane) { return weight / errors.weight * plane.misfit; };
  const bool is_explained = !both.empty() && told(both.front()) - free_misfit < clearly_contradicted;
  return is_explained ? both : solve_plane(edges.points(), guesses, errors);
}

}  // namespace

double unusual(const PlaneTilt& tilt) {
  const double turned = std::acos(std::min(1.0, std::abs(tilt.turn(2, 2)))) / usual_turn_rad;
  return turned * turned / 2;
}

double usual_turn(const PlanePose& pose) {
  return std::lerp(std::exp(-unusual(pose)), std::exp(-unusual(pose.other)), pose.share_of_other());
}

bool PlanePose::is_contradicted() const { return misfit - free_misfit > clearly_contradicted; }

double PlanePose::odds_of_no_plane() const {
  const double evidence = (misfit - free_misfit) * (by_both ? share_of_both : 1);
  return no_planes_for_one * std::exp(std::min(evidence, 50.0));
}

bool PlanePose::shows_perspective() const { return affine_misfit - misfit > clearly_worse; }

double PlanePose::share_of_other() const {
  const double worse = by_both ? other.misfit - misfit : unlikely(other) - unlikely(*this);
  return 1 / (1 + std::exp(std::clamp(worse, -50.0, 50.0)));
}

std::optional<PlanePose> plane_pose(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& left,
                                    const PlaneFace& face, const PlaneFit* right) {
  const bool by_both = right != nullptr;
  PoseEdges edges(model, outline, face, PoseEdges::Which::all);
  PoseEdges straight(model, outline, face, PoseEdges::Which::straight);
  edges.add(left, 0);
  straight.add(left, 0);
  if (edges.points().size() < least_edges) return std::nullopt;
  if (by_both) {
    edges.add(*right, model.base_line_mm);
    straight.add(*right, model.base_line_mm);
  }
  // Blur and the template round what is near a corner, each in its own way: its edges are off together, and hardly say
  // where the mark is. They do say which explanation is the better one before one camera; a pair knows that.
  const PoseEdges& best = straight.are_enough_of(edges) ? straight : edges;
  const PlaneErrors of_best = errors_of(best, face, stretch_of_outline, by_both);
  const PoseEdges& explaining = by_both ? best : edges;
  const PlaneErrors errors = by_both ? of_best : errors_of(edges, face, least_stretch, by_both);
  const std::vector<SolvedPlane> both = explained(model, outline, left, explaining, face, errors, by_both);
  if (both.empty()) return std::nullopt;
  const double weight = explaining.scatter().weight_of_explanations();
  const auto told = [&](const SolvedPlane& solved) {
    const double misfit = weight / errors.weight * solved.misfit;
    const SolvedPlane finest = by_both ? solved : refined(solved, best, of_best);
    PlaneTilt tilt = tilt_of(model, finest, misfit);
    tilt.off_if_hidden_px = off_if_hidden_px(model, best, of_best, finest.pose);
    return tilt;
  };
  const PlaneTilt best_explained = told(both.front());
  PlanePose out{best_explained, both.size() > 1 ? told(both.back()) : best_explained};
  out.by_both = by_both;
  if (!by_both && unlikely(out.other) < unlikely(out)) std::swap(static_cast<PlaneTilt&>(out), out.other);
  if (!by_both) out.affine_misfit = affine_misfit(edges.points(), errors, weight);
  out.free_misfit = weight * explaining.scatter().squares / 2;
  return out;
}

double PlanePose::most_off_if_hidden_px() const {
  const bool either = share_of_other() > least_share_of_other;
  return either ? std::max(off_if_hidden_px, other.off_if_hidden_px) : off_if_hidden_px;
}

cv::Point2d middle_in_image(const camera::StereoModel& model, const PlanePose& pose, double most_off_px) {
  const cv::Point2d told = in_image(model, pose.place_mm);
  const cv::Point2d other = in_image(model, pose.other.place_mm);
  const double of_other = pose.share_of_other();
  const double most_px = share_of_tilt * most_off_px;
  const double most = std::max(0.5, most_px / std::max(most_px, cv::norm(told - other)));
  const bool either = of_other > least_share_of_other;
  const double share = either ? std::clamp(of_other, 1 - most, most) : of_other;
  return (1 - share) * told + share * other;
}

double covered_rather_than_tilted(const PlanePose& pose, double tilted_for_one_covered) {
  const double by_perspective =
      1 / (1 + tilted_for_one_covered * std::exp(std::clamp(pose.affine_misfit - pose.misfit, -50.0, 50.0)));
  // What is covered and tilted besides is neither.
  const double contradicted = pose.misfit - pose.free_misfit - least_contradiction;
  return contradicted > 0 ? std::max(by_perspective, 1 - std::exp(-contradicted)) : by_perspective;
}

double off_if_bent_px(const PlaneOutline& outline, const PlaneFit& fit) {
  double together = 0;
  double apart = 0;
  int count = 0;
  const PlaneEdge* before = nullptr;
  for (const PlaneEdge& edge : fit.edges) {
    const bool there = edge.counts && edge.is_border && !outline.points[edge.point].is_rounded();
    if (there && before != nullptr) {
      together += edge.off_px * edge.off_px;
      apart += (edge.off_px - before->off_px) * (edge.off_px - before->off_px) / 2;
      ++count;
    }
    before = there ? &edge : nullptr;
  }
  if (count == 0) return 0;
  // Of a disc, which takes up most: measured of discs of which a straight edge hides up to a tenth.
  constexpr double moved_by_bent = 4;
  return moved_by_bent * std::sqrt(std::max(0.0, together - apart) / count);
}

}  // namespace pizarra::vision
