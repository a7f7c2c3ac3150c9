#include "agents/vision/marks/other_outline.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pizarra::vision {
namespace {

// Lengths are in standard deviations of the mark. An edge farther off is of something else.
constexpr double most_off = 0.3;
// Nearer to a corner blur and the template bend a border.
constexpr double near_corner = 0.25;
constexpr double near_corner_px = 1.5;
// The part of the border that must be there, and so many edges.
constexpr double least_found = 0.3;
constexpr Eigen::Index least_edges = 16;
// The part of another outline that a homography must leave for the edges to show it.
constexpr double least_left = 0.1;
// A homography's number that moves the edges by less than this part of what the first one does counts as open.
constexpr double least_taken_up = 0.01;
// Neighbouring edges' errors correlate by at most this.
constexpr double most_in_common = 0.9;

// Fewer waves a homography takes up. Polygons of more corners are circles to these eyes.
constexpr int fewest_corners = 3;
constexpr int most_corners = 8;
// Blur leaves at least so much of a polygon's wave.
constexpr double left_by_blur = 0.4;
// How high a wave a template makes of a circle, and the pixels' phase: standard deviations.
constexpr double wave_of_template = 0.004;
constexpr double wave_of_phase_px = 0.012;

// A corner that is round has about this radius, for a side at least three times as long. How round it is, for as much
// as that: what is called another outline, and how far a template and blur are off.
constexpr double rounding_radius = 0.8;
constexpr double sides_in_radii = 3;
constexpr double least_rounding = 0.4;
constexpr double most_rounding = 1.5;
constexpr double rounding_spread = 0.1;

// How many marks of another outline there are for each one, of those that are as like it as this.
constexpr double others_for_one = 0.005;
constexpr double most_evidence = 50;

using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, PlaneOutline::count, 8>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, PlaneOutline::count, 1>;

// How much of another outline the edges show.
struct Shown {
  double amount = 0;
  double spread = 0;  // a standard deviation, by what it leaves of how far the edges are off; 0: they do not tell
};

// By how much better it explains the edges than none of it, as a logarithm, where there would be so much of it.
double evidence_of(const Shown& shown, double systematic, double least, double most) {
  const double spread = std::hypot(shown.spread, systematic);
  const double other = std::clamp(shown.amount, least, most);
  return other * (2 * shown.amount - other) / (2 * spread * spread);
}

// How far the edges of the outermost border are off, without what a homography takes up.
class EdgesOff {
 public:
  EdgesOff(const PlaneOutline& outline, const PlaneFit& fit)
      : step_(2 * std::numbers::pi / static_cast<double>(outline.outermost)),
        off_(outline.outermost),
        turns_(outline.outermost),
        rounded_(outline.outermost),
        taken_up_(outline.outermost, 8) {
    const double bent = std::max(near_corner, near_corner_px / fit.size_px());
    for (const PlaneEdge& edge : fit.edges) {
      const PlaneOutline::Point& point = outline.points[edge.point];
      if (edge.point >= outline.outermost || !edge.found || !edge.measures || point.from_bend < bent) continue;
      // A normal goes with the inverse transpose.
      const double off = edge.off_px * cv::norm(fit.slope_at(point.at).inv().t() * point.out);
      if (std::abs(off) < most_off) add(point, off, step_ * static_cast<double>(edge.point));
    }
    for (Column* column : {&off_, &turns_, &rounded_}) column->conservativeResize(count_);
    taken_up_.conservativeResize(count_, 8);
    if (count_ < least_edges) return;
    // A circle leaves some of a homography's numbers open.
    Eigen::ColPivHouseholderQR<Columns> solved;
    solved.setThreshold(least_taken_up);
    solved.compute(taken_up_);
    taken_up_ = solved.householderQ() * Columns::Identity(count_, solved.rank());
    off_ = left_of(off_);
  }
  Eigen::Index count() const { return count_; }

  // A wave's crest, wherever along the border that is.
  Shown wave(int waves) const {
    Eigen::Matrix<double, Eigen::Dynamic, 2, 0, PlaneOutline::count, 2> wave(count_, 2);
    wave.col(0) = left_of((waves * turns_).array().cos());
    wave.col(1) = left_of((waves * turns_).array().sin());
    const Eigen::Matrix2d normal = wave.transpose() * wave;
    if (normal.determinant() < std::pow(least_left * static_cast<double>(count_) / 2, 2)) return {};
    const Eigen::Vector2d height = normal.inverse() * (wave.transpose() * off_);
    return {height.norm(), std::sqrt(variance(off_ - wave * height, waves) * normal.inverse().trace() / 2)};
  }
  Shown rounding() const {
    const Column rounded = left_of(rounded_);
    const double normal = rounded.squaredNorm();
    if (normal < least_left * rounded_.squaredNorm() || normal <= 0) return {};
    const double amount = rounded.dot(off_) / normal;
    return {amount, std::sqrt(variance(off_ - amount * rounded, fewest_corners) / normal)};
  }

 private:
  void add(const PlaneOutline::Point& point, double off, double turn) {
    const auto [x, y] = std::pair(point.at[0], point.at[1]);
    const auto [nx, ny] = std::pair(point.out[0], point.out[1]);
    const double along = nx * x + ny * y;
    taken_up_.row(count_) << nx * x, nx * y, nx, ny * x, ny * y, ny, -along * x, -along * y;
    const double into_arc = std::max(0.0, rounding_radius - point.from_bend);
    rounded_[count_] = std::sqrt(rounding_radius * rounding_radius - into_arc * into_arc) - rounding_radius;
    off_[count_] = off;
    turns_[count_] = turn;
    ++count_;
  }
  Column left_of(const Column& all) const { return all - taken_up_ * (taken_up_.transpose() * all); }
  // Of noise whose neighbours correlate (a process of first order along the border), as it is at so many waves.
  double variance(const Column& noise, int waves) const {
    double beside = 0;
    double squares = 0;
    for (Eigen::Index i = 1; i < count_; ++i) {
      if (turns_[i] - turns_[i - 1] > 1.5 * step_) continue;
      beside += noise[i] * noise[i - 1];
      squares += (noise[i] * noise[i] + noise[i - 1] * noise[i - 1]) / 2;
    }
    const double alike = squares > 0 ? std::clamp(beside / squares, 0.0, most_in_common) : 0;
    const double power = (1 - alike * alike) / (1 - 2 * alike * std::cos(waves * step_) + alike * alike);
    return power * noise.squaredNorm() / static_cast<double>(count_ - taken_up_.cols() - 2);
  }

  const double step_;
  Eigen::Index count_ = 0;
  Column off_;
  Column turns_;
  Column rounded_;    // how far a round corner lies from the outline
  Columns taken_up_;  // by a homography: orthonormal
};

// The crest of a regular polygon around a circle, whose radius is two standard deviations: the first term of the series
// of a row of parabolas.
double crest_of_polygon(int corners) {
  const double higher = 1 / std::cos(std::numbers::pi / corners) - 1;
  return 2 * 4 / (std::numbers::pi * std::numbers::pi) * higher;
}

double evidence_of_polygon(const EdgesOff& edges, double size) {
  double most = -most_evidence;
  for (int corners = fewest_corners; corners <= most_corners; ++corners) {
    const Shown wave = edges.wave(corners);
    if (wave.spread <= 0) continue;
    const double systematic = std::hypot(wave_of_template, wave_of_phase_px / size);
    const double crest = crest_of_polygon(corners);
    most = std::max(most, evidence_of(wave, systematic, left_by_blur * crest, crest));
  }
  return most;
}

double evidence_of_rounding(const EdgesOff& edges) {
  const Shown round = edges.rounding();
  if (round.spread <= 0) return -most_evidence;
  return evidence_of(round, rounding_spread, least_rounding, most_rounding);
}

}  // namespace

double odds_of_other_outline(const PlaneOutline& outline, const PlaneFit& fit) {
  if (outline.outermost < least_edges) return 0;
  const std::span<const PlaneOutline::Point> points(outline.points.data(), outline.outermost);
  const double half_side = std::ranges::max(points, {}, &PlaneOutline::Point::from_bend).from_bend;
  const bool is_round = std::isinf(half_side);
  if (!is_round && 2 * half_side < sides_in_radii * rounding_radius) return 0;
  const EdgesOff edges(outline, fit);
  const double least = std::max(static_cast<double>(least_edges), least_found * static_cast<double>(outline.outermost));
  if (static_cast<double>(edges.count()) < least) return 0;
  const double evidence = is_round ? evidence_of_polygon(edges, fit.size_px()) : evidence_of_rounding(edges);
  return others_for_one * std::exp(std::min(evidence, most_evidence));
}

}  // namespace pizarra::vision
