#include "agents/vision/sight/unyawed.hpp"

#include <algorithm>
#include <cmath>

#include "agents/vision/objects/mark_match.hpp"

namespace pizarra::vision {
namespace {

// How far turning in the image changes the height of a nearly round mark, as a part of what it lacks to be round.
constexpr double turning_share = 0.1;
// How far a slimness is off, as a part of it, by the light's slope and the pixels' phase.
constexpr double slimness_spread = 0.005;

}  // namespace

// A mark that is widened by u along x has the trace xx u^2 + yy and u times the root of the determinant; both say how
// slim it is then: s / (1 + s^2) = root u / (xx u^2 + yy). The equation has two solutions. The
// one nearer to 1 is taken: the other belongs to a mark turned by 90 degrees and yawed far. When a mark is as wide as
// it is high, neither is certain: a little yaw changes its direction and not its slimness.
Unyawed unyawed(const SeenMark& mark, double front_slimness, double shown_height) {
  const double height = mark.height_px / shown_height;
  if (front_slimness >= least_round) {
    return {.size_px = height, .shown = mark.width_px / height, .spread = turning_share * (1 - front_slimness)};
  }
  const double slant = mark.slant_px2 / shown_height;
  const double xx = mark.width_px * mark.width_px;
  const double yy = height * height;
  const double root = std::sqrt(xx * yy - slant * slant);
  const double by_slimness = front_slimness / (1 + front_slimness * front_slimness);
  const double apart2 = 1 - 4 * by_slimness * by_slimness * xx * yy / (root * root);
  const double apart = std::sqrt(std::max(0.0, apart2));
  const double middle = root / (2 * by_slimness * xx);
  const double nearest = yy > xx ? middle * (1 - apart) : middle * (1 + apart);
  const double widened = std::max(1.0, nearest);
  const double noise = slimness_spread + centre_spread_px(mark, mark.noise) / std::min(mark.width_px, height);
  return {.size_px = std::sqrt(root * widened),
          .shown = 1 / widened,
          .spread = noise / std::sqrt(apart * apart + noise) / 2};
}

}  // namespace pizarra::vision
