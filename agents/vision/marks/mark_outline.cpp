#include "agents/vision/marks/mark_outline.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/hal/intrin.hpp>

namespace pizarra {
namespace {

constexpr int turns = MarkSignature::turns;
constexpr int waves = MarkOutline::count;
// So much of the learned waves a blur leaves at least; noise may add to them.
constexpr double least_part = 0.5;
constexpr double most_part = 1.1;
// What the three waves of a triangle have at least, in its squared standard deviations.
constexpr double least_triangle_power = 0.02;

using Round = std::array<float, turns>;  // a value for each turn

float product(const Round& a, const Round& b) {
  cv::v_float32x4 sum = cv::v_setzero_f32();
  for (std::size_t i = 0; i < a.size(); i += 4) sum += cv::v_load(a.data() + i) * cv::v_load(b.data() + i);
  return cv::v_reduce_sum(sum);
}

struct Waves {
  std::array<Round, waves> cosines;
  std::array<Round, waves> sines;
};

const Waves& unit_waves() {
  static const Waves table = [] {
    Waves out{};
    for (std::size_t wave = 0; wave < waves; ++wave) {
      for (std::size_t turn = 0; turn < turns; ++turn) {
        const double angle = 2 * CV_PI * static_cast<double>((MarkOutline::first + wave) * turn) / turns;
        out.cosines[wave][turn] = static_cast<float>(std::cos(angle));
        out.sines[wave][turn] = static_cast<float>(std::sin(angle));
      }
    }
    return out;
  }();
  return table;
}

// How much of each wave both have in common, by how far the learned one is turned.
struct Agreement {
  MarkOutline common;

  Agreement(const MarkOutline& seen, const MarkOutline& learned) {
    for (std::size_t i = 0; i < waves; ++i) {
      common.cosines[i] = seen.cosines[i] * learned.cosines[i] + seen.sines[i] * learned.sines[i];
      common.sines[i] = seen.sines[i] * learned.cosines[i] - seen.cosines[i] * learned.sines[i];
    }
  }
  // Of all, and its first two derivatives.
  std::array<double, 3> at(double angle) const {
    const double step_cosine = std::cos(angle);
    const double step_sine = std::sin(angle);
    double cosine = std::cos(MarkOutline::first * angle);
    double sine = std::sin(MarkOutline::first * angle);
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < waves; ++i) {
      const auto wave = static_cast<double>(MarkOutline::first + i);
      const double value = common.cosines[i] * cosine + common.sines[i] * sine;
      out[0] += value;
      out[1] += wave * (common.sines[i] * cosine - common.cosines[i] * sine);
      out[2] -= wave * wave * value;
      const double next = cosine * step_cosine - sine * step_sine;
      sine = sine * step_cosine + cosine * step_sine;
      cosine = next;
    }
    return out;
  }
  int best_turn() const {
    const Waves& unit = unit_waves();
    Round sums{};
    for (std::size_t i = 0; i < waves; ++i) {
      for (std::size_t turn = 0; turn < turns; ++turn) {
        sums[turn] += common.cosines[i] * unit.cosines[i][turn] + common.sines[i] * unit.sines[i][turn];
      }
    }
    return static_cast<int>(std::ranges::max_element(sums) - sums.begin());
  }
  // At the best angle: one step of Newton's method from the best turn.
  double best() const {
    const double angle = 2 * CV_PI * best_turn() / turns;
    const auto [value, slope, curvature] = at(angle);
    return curvature < 0 ? std::max(value, at(angle - slope / curvature)[0]) : value;
  }
};

}  // namespace

double MarkOutline::power() const {
  double sum = 0;
  for (std::size_t i = 0; i < waves; ++i) sum += cosines[i] * cosines[i] + sines[i] * sines[i];
  return sum / 2;
}

MarkOutline outline_of(const MarkSignature& signature) {
  const Round reach = reach_of(signature);
  const Waves& unit = unit_waves();
  MarkOutline out;
  for (std::size_t i = 0; i < waves; ++i) {
    out.cosines[i] = 2 * product(reach, unit.cosines[i]) / turns;
    out.sines[i] = 2 * product(reach, unit.sines[i]) / turns;
  }
  return out;
}

bool is_triangle(const MarkOutline& outline) {
  const auto power = [&](std::size_t waves_around) {
    const std::size_t i = waves_around - MarkOutline::first;
    return outline.cosines[i] * outline.cosines[i] + outline.sines[i] * outline.sines[i];
  };
  return power(3) > std::max<double>(least_triangle_power, power(4));
}

double outline_error(const MarkOutline& seen, const MarkOutline& learned) {
  const double power = learned.power();
  // The mean square of a wave is half of its amplitude's.
  const double common = Agreement(seen, learned).best() / 2;
  const double part = power > 0 ? std::clamp(common / power, least_part, most_part) : 1;
  return std::max(0.0, seen.power() - 2 * part * common + part * part * power);
}

}  // namespace pizarra
