#include "agents/vision/marks/ground_step.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::vision {
namespace {

// A side has so many parts.
constexpr std::size_t least_side = 3;
constexpr std::size_t most_side = around_parts / 2;
// By how much ground differs that is one: grey levels, a part of the contrast, and standard deviations of noise, of
// which the most unlike of so many sides has some four.
constexpr double uneven_levels = 5;
constexpr double uneven_share = 0.03;
constexpr double most_deviations = 8;

// A side and the ground beyond the others, as a plane with a step.
struct Step {
  double height = 0;  // grey levels
  double weight = 0;  // so many samples of the height's own would say as much
  double apart = 1;   // how much of that the plane leaves: what is uneven counts the more, the more it is like a slope

  // How much of the squared differences from a plane it explains.
  double explained() const { return height * height * weight; }
};

// By linear least squares: of all sides the one whose step explains most.
Step most_unlike_side(const Around& flat, const cv::Matx33d& inverse) {
  Step best;
  double count = 0;
  for (const LevelSamples& part : flat) count += part.count;
  for (std::size_t first = 0; first < around_parts; ++first) {
    LevelSamples side;
    for (std::size_t length = 1; length <= most_side; ++length) {
      side += flat[(first + length - 1) % around_parts];
      if (length < least_side) continue;
      const double weight = side.count - side.row().dot(inverse * side.row());
      if (weight <= 1) continue;
      const Step step{side.level / weight, weight, weight / (side.count - side.count * side.count / count)};
      if (step.explained() > best.explained()) best = step;
    }
  }
  return best;
}

// Of one sample about plane and step: as they scatter, and no less than noise makes of what lies between pixels.
double variance_of(const Around& flat, const Step& step, double noise) {
  constexpr int unknowns = 4;
  double squares = -step.explained();
  int known = -unknowns;
  for (const LevelSamples& part : flat) {
    if (part.count == 0) continue;
    squares += part.level * part.level / part.count;
    ++known;
  }
  return std::max(squares / std::max(1, known), variance_between_pixels(noise));
}

}  // namespace

double variance_between_pixels(double noise) {
  constexpr double left_between_pixels = 0.5;
  return left_between_pixels * noise * noise;
}

cv::Matx33d flatten(Around& all) {
  cv::Matx33d normal = cv::Matx33d::zeros();
  cv::Vec3d right = cv::Vec3d::all(0);
  for (const LevelSamples& part : all) {
    if (part.count == 0) continue;
    normal += part.row() * part.row().t() * (1 / part.count);
    right += part.level / part.count * part.row();
  }
  const cv::Matx33d inverse = normal.inv();
  const cv::Vec3d plane = inverse * right;
  for (LevelSamples& part : all) part.level -= plane.dot(part.row());
  return inverse;
}

double step_doubt(Around beyond, double contrast, double noise) {
  const cv::Matx33d inverse = flatten(beyond);
  const Step step = most_unlike_side(beyond, inverse);
  if (step.weight == 0) return 0;
  const double spread = std::sqrt(variance_of(beyond, step, noise) / step.weight);
  const double uneven = std::hypot(uneven_levels, uneven_share * contrast) / std::sqrt(step.apart);
  return std::abs(step.height) / std::hypot(uneven, most_deviations * spread);
}

}  // namespace pizarra::vision
