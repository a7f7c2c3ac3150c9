#include "agents/vision/marks/light_or_cover.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pizarra::vision {
namespace {

constexpr double most_certain = 50;
// Before anything is seen of the print: what hides a part is to be excluded.
constexpr double covers_for_one_light = 9;
// By how much print differs from place to place, grey levels; and how light's slope changes it over the mark's standard
// deviation, as a part of its level.
constexpr double uneven_print = 1;
constexpr double usual_slope = 0.05;
// Some places show something else: so likely is any level, for one that is just as expected.
constexpr double least_likely = 1e-3;
// How often a shadow's edge runs between a place of the border and the print that is measured beside it.
constexpr double edge_between = 0.5;
// Neighbouring places share pixels.
constexpr double independent_share = 0.5;

struct PrintAndGround {
  Around print{};
  Around ground{};
};

PrintAndGround around_of(std::span<const PrintBeside> places) {
  PrintAndGround out;
  for (const PrintBeside& place : places) {
    out.print[place.part] += {1, place.at, place.print};
    out.ground[place.part] += {1, place.at, place.ground};
  }
  return out;
}

double mean_level(const Around& around) {
  LevelSamples all;
  for (const LevelSamples& part : around) all += part;
  return all.level / std::max(1.0, all.count);
}

double parts_seen(const Around& around) {
  return static_cast<double>(std::ranges::count_if(around, [](const LevelSamples& part) { return part.count > 0; }));
}

// How much likelier the print's levels are in a shadow than in one light, as a logarithm. In a shadow print and ground
// are as many times darker. Where the shadow's edge runs between a place of the border and its print, the print is as
// dark as that elsewhere.
class Shadow {
 public:
  Shadow(std::span<const PrintBeside> places, const PrintAndGround& means, double noise)
      : places_(places),
        variance_(noise * noise + uneven_print * uneven_print),
        print_of_ground_(mean_level(means.print) / std::max(1.0, mean_level(means.ground))) {
    for (const LevelSamples& part : means.ground) {
      if (part.count > 0) grounds_.push_back(part.level / part.count);
    }
    fit_slope_of_light(mean_level(means.print));
  }
  double rather_than_one_light() const {
    double out = 0;
    for (const PrintBeside& place : places_) {
      double elsewhere = 0;
      for (const double ground : grounds_) elsewhere += likely(place.print - print_of_ground_ * ground);
      elsewhere /= static_cast<double>(grounds_.size());
      const double in_shadow =
          std::lerp(likely(place.print - print_of_ground_ * place.ground), elsewhere, edge_between);
      out += std::log(in_shadow / likely(place.print - one_light_.dot(row_of(place))));
    }
    return independent_share * out + unlikely_slope_;
  }

 private:
  static cv::Vec3d row_of(const PrintBeside& place) { return {1, place.at.x, place.at.y}; }
  double likely(double off) const { return std::exp(-off * off / (2 * variance_)) + least_likely; }

  // By least squares, with a prior: a steep slope over so little of an image is a shadow's.
  void fit_slope_of_light(double print) {
    cv::Matx33d normal = cv::Matx33d::zeros();
    cv::Vec3d right = cv::Vec3d::all(0);
    double squares = 0;
    for (const PrintBeside& place : places_) {
      normal += row_of(place) * row_of(place).t();
      right += place.print * row_of(place);
      squares += place.at.dot(place.at);
    }
    const double spread_px2 = squares / 2 / static_cast<double>(places_.size());
    const double usual = usual_slope * std::max(1.0, print);  // over the root of that
    normal(1, 1) += variance_ * spread_px2 / (usual * usual);
    normal(2, 2) += variance_ * spread_px2 / (usual * usual);
    one_light_ = normal.inv() * right;
    const double slope2 = one_light_[1] * one_light_[1] + one_light_[2] * one_light_[2];
    unlikely_slope_ = slope2 * spread_px2 / (usual * usual) / 2;
  }

  std::span<const PrintBeside> places_;
  double variance_;
  double print_of_ground_;
  std::vector<double> grounds_;
  cv::Vec3d one_light_;
  double unlikely_slope_ = 0;  // half of the squared deviations
};

// The same for light that may also be added to both. The light's slope is taken from print and ground, and by least
// squares it is found how much the print changes with the ground: in a shadow in proportion to its level, and by as
// much as the ground where light is added.
double for_any_light(PrintAndGround around, double noise) {
  const double least_of_light = std::min(1.0, mean_level(around.print) / std::max(1.0, mean_level(around.ground)));
  flatten(around.print);
  flatten(around.ground);
  double ground2 = 0;
  double both = 0;
  double print2 = 0;
  for (std::size_t i = 0; i < around_parts; ++i) {
    const double count = std::max(1.0, around.ground[i].count);
    ground2 += around.ground[i].level * around.ground[i].level / count;
    both += around.ground[i].level * around.print[i].level / count;
    print2 += around.print[i].level * around.print[i].level / count;
  }
  const double slope = both / std::max(1.0, ground2);
  constexpr double unknowns = 4;
  const double scatter = (print2 - slope * both) / (parts_seen(around.print) - unknowns);
  const double variance = std::max(scatter, variance_between_pixels(noise)) / std::max(1.0, ground2);
  const double off = std::max(0.0, least_of_light - slope);
  return (slope * slope - off * off) / (2 * variance);
}

}  // namespace

double light_rather_than_cover(std::span<const PrintBeside> places, double noise) {
  constexpr double least_parts = 8;
  const PrintAndGround around = around_of(places);
  if (parts_seen(around.print) < least_parts) return 0;
  const double for_light =
      std::max(for_any_light(around, noise), Shadow(places, around, noise).rather_than_one_light());
  return 1 / (1 + covers_for_one_light * std::exp(-std::clamp(for_light, -most_certain, most_certain)));
}

}  // namespace pizarra::vision
