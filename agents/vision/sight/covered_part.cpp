#include "agents/vision/sight/covered_part.hpp"

#include <algorithm>
#include <cmath>

#include "agents/vision/objects/recognise.hpp"

namespace pizarra::vision {

const double motion_by_strip = std::sqrt(3.0);
const double triangle_reach = std::sqrt(8.0);

// The root of the covariance's determinant.
double spread_product_px2(const SeenMark& mark) {
  return std::sqrt(std::pow(mark.width_px * mark.height_px, 2) - mark.slant_px2 * mark.slant_px2);
}

double off_if_missing_px(const SeenMark& now, double missing) {
  return motion_by_strip * std::max(now.width_px, now.height_px) * std::max(0.0, missing);
}

// Its shorter side by so much as it is too slim; its longer one by so much as it is not slim enough.
double may_be_off_by_shape_px(const SeenMark& now, double front_slimness) {
  const double longer = std::sqrt(spread_product_px2(now) / now.slimness);
  const double missing = std::max(front_slimness - now.slimness, now.slimness / front_slimness - 1);
  return motion_by_strip * std::max(0.0, missing) * longer;
}

double confidence_if_off(double of_whole, double off_px, double most_off_px) {
  return 1 / (1 / of_whole + std::exp(-(1 - off_px / most_off_px) / doubt_scale));
}

double confidence_in_whole(double confidence, double of_object) { return 1 / (1 + 1 / confidence - 1 / of_object); }

}  // namespace pizarra::vision
