#pragma once

// Numbers that looks at the gripper's mark tell of, by least squares: Gauss and Newton's steps from a guess with
// standard deviations, so that whatever the looks leave open stays as it was guessed. Looks that do not agree with the
// others weigh less.
//
//   const auto expected = [&](const Numbers<9>& numbers, const MarkPair& pair) -> SeenMark { ... };
//   const MarkFit<9> fit = fit_to_marks<9>(guess, deviations, pairs, expected);

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

#include "agents/coordinator/geometry/camera_pose.hpp"

namespace pizarra::coordinator {

template <int N>
using Numbers = Eigen::Matrix<double, N, 1>;

template <int N>
struct MarkFit {
  Numbers<N> numbers;
  Eigen::Matrix<double, N, N> covariance;
  double error_px = 0;  // root mean square over the pairs, each coordinate
};

// Of a pair's looks together, each coordinate.
double deviation_px(const MarkPair& pair);

// Of a symmetric matrix, the least first. Its closed form: the iterative one takes ten seconds to compile.
Eigen::Vector3d eigenvalues_of(const Eigen::Matrix3d& symmetric);

// How what `value` answers, three numbers, changes with each of N.
template <int N, class Value>
Eigen::Matrix<double, 3, N> slopes(const Numbers<N>& numbers, const Value& value) {
  constexpr double step = 1e-3;
  Eigen::Matrix<double, 3, N> out;
  for (int i = 0; i < N; ++i) {
    Numbers<N> up = numbers;
    Numbers<N> down = numbers;
    up[i] += step;
    down[i] -= step;
    out.col(i) = (value(up) - value(down)) / (2 * step);
  }
  return out;
}

// The normal equations of the pairs, and of the guess where the pairs leave something open.
template <int N>
struct MarkNormal {
  Eigen::Matrix<double, N, N> information;
  Numbers<N> gradient;
  double squares_px = 0;
};

template <int N, class Expected>
MarkNormal<N> mark_normal(const Numbers<N>& numbers, const Numbers<N>& guess, const Numbers<N>& deviations,
                          std::span<const MarkPair> pairs, const Expected& expected, bool alike) {
  // A pair that is so many deviations off weighs half.
  constexpr double half_weight_at = 3;
  MarkNormal<N> normal;
  const Numbers<N> trust = deviations.cwiseInverse().cwiseAbs2();
  normal.information = trust.asDiagonal();
  normal.gradient = trust.cwiseProduct(guess - numbers);
  for (const MarkPair& pair : pairs) {
    const SeenMark missing = pair.seen - expected(numbers, pair);
    const auto slope = slopes<N>(numbers, [&](const Numbers<N>& at) { return expected(at, pair); });
    const double off = missing.norm() / deviation_px(pair);
    const double agreement = alike ? 1 : 1 / (1 + std::pow(off / half_weight_at, 2));
    const double weight = agreement / std::pow(deviation_px(pair), 2);
    normal.information += weight * slope.transpose() * slope;
    normal.gradient += weight * slope.transpose() * missing;
    normal.squares_px += missing.squaredNorm();
  }
  return normal;
}

template <int N, class Expected>
MarkFit<N> fit_to_marks(const Numbers<N>& guess, const Numbers<N>& deviations, std::span<const MarkPair> pairs,
                        const Expected& expected) {
  constexpr int most_steps = 15;
  // The first steps count all pairs alike: from a guess that is far off, all of them are.
  constexpr int steps_alike = 3;
  constexpr double small_step = 1e-4;
  Numbers<N> numbers = guess;
  MarkNormal<N> normal = mark_normal<N>(numbers, guess, deviations, pairs, expected, true);
  for (int step = 1; step <= most_steps; ++step) {
    const Numbers<N> change = normal.information.ldlt().solve(normal.gradient);
    numbers += change;
    const bool alike = step < steps_alike;
    normal = mark_normal<N>(numbers, guess, deviations, pairs, expected, alike);
    if (!alike && change.norm() < small_step) break;
  }
  const double coordinates = 3.0 * static_cast<double>(std::max<std::size_t>(pairs.size(), 1));
  return {numbers, normal.information.inverse(), std::sqrt(normal.squares_px / coordinates)};
}

}  // namespace pizarra::coordinator
