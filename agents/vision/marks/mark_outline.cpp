#include "agents/vision/marks/mark_outline.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core/hal/intrin.hpp>

namespace pizarra::vision {
namespace {

constexpr int turns = MarkSignature::turns;
constexpr int waves = MarkOutline::count;
// So much of the learned waves a blur of b standard deviations leaves at least: 1 - 3 b^2, of the finest ones, those of
// a cross, down to a half. Noise may add to them.
constexpr double lost_by_blur = 3;
constexpr double least_part = 0.5;
constexpr double most_part = 1.1;
// The least power of a triangle's three waves, in its squared standard deviations; and the most power of the waves that
// neither a triangle nor another regular form has, as a part of it. A T has a twelfth, a half disc and a drop a fifth.
constexpr double least_triangle_power = 0.01;
constexpr double most_of_other_waves = 0.06;
// Noise gives a circle's outline as much.
constexpr double least_power_of_form = 0.001;

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
  // Calls use(i, cosine, sine) with those of every wave's angle.
  static void for_each_wave(double angle, auto use) {
    const double step_cosine = std::cos(angle);
    const double step_sine = std::sin(angle);
    double cosine = 1;
    double sine = 0;
    for (std::size_t wave = 0; wave < MarkOutline::first + waves; ++wave) {
      if (wave >= MarkOutline::first) use(wave - MarkOutline::first, cosine, sine);
      const double next = cosine * step_cosine - sine * step_sine;
      sine = sine * step_cosine + cosine * step_sine;
      cosine = next;
    }
  }
  // Of all, and its first two derivatives.
  std::array<double, 3> at(double angle) const {
    std::array<double, 3> out{};
    for_each_wave(angle, [&](std::size_t i, double cosine, double sine) {
      const auto wave = static_cast<double>(MarkOutline::first + i);
      const double value = common.cosines[i] * cosine + common.sines[i] * sine;
      out[0] += value;
      out[1] += wave * (common.sines[i] * cosine - common.cosines[i] * sine);
      out[2] -= wave * wave * value;
    });
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
  // One step of Newton's method from the best turn; and how much they agree there.
  struct Best {
    double angle, value;
  };
  Best best() const {
    const double angle = 2 * CV_PI * best_turn() / turns;
    const auto [value, slope, curvature] = at(angle);
    if (curvature >= 0) return {angle, value};
    const double better = angle - slope / curvature;
    const double then = at(better)[0];
    return then > value ? Best{better, then} : Best{angle, value};
  }
};

// Of the waves that a turn by this part of a whole one changes.
double power_of_others(MarkOutline outline, int fold) {
  for (int wave = fold; wave < MarkOutline::first + MarkOutline::count; wave += fold) {
    const auto i = static_cast<std::size_t>(wave - MarkOutline::first);
    outline.cosines[i] = outline.sines[i] = 0;
  }
  return outline.power();
}

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

bool is_regular(const MarkOutline& outline) {
  const double most = std::max(least_power_of_form, most_of_other_waves * outline.power());
  for (int fold = MarkOutline::first; fold < MarkOutline::first + MarkOutline::count; ++fold) {
    if (power_of_others(outline, fold) < most) return true;
  }
  return false;
}

bool is_triangle(const MarkOutline& outline) {
  constexpr std::size_t three = 3 - MarkOutline::first;
  const double power =
      (outline.cosines[three] * outline.cosines[three] + outline.sines[three] * outline.sines[three]) / 2;
  return power > least_triangle_power && power_of_others(outline, 3) < most_of_other_waves * power;
}

OutlineDifference outline_difference(const MarkOutline& seen, const MarkOutline& learned, double most_blur) {
  const Agreement agreement(seen, learned);
  const Agreement::Best best = agreement.best();
  const double power = learned.power();
  const double least = std::max(least_part, 1 - lost_by_blur * most_blur * most_blur);
  // The mean square of a wave is half of its amplitude's.
  const double part = power > 0 ? std::clamp(best.value / 2 / power, least, most_part) : 1;
  OutlineDifference out;
  Agreement::for_each_wave(best.angle, [&](std::size_t i, double cosine, double sine) {
    const double common = agreement.common.cosines[i] * cosine + agreement.common.sines[i] * sine;
    const double of_seen = seen.cosines[i] * seen.cosines[i] + seen.sines[i] * seen.sines[i];
    const double of_learned = learned.cosines[i] * learned.cosines[i] + learned.sines[i] * learned.sines[i];
    const double left = std::max(0.0, of_seen - 2 * part * common + part * part * of_learned) / 2;
    out.in_all += left;
    out.in_one = std::max(out.in_one, left);
  });
  return out;
}

}  // namespace pizarra::vision
