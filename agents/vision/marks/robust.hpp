#pragma once

// Statistics that a few values far off do not move.
//
//   const double spread = deviations_of_median * median(sizes_of_errors);
//   const double weight = tukey_weight(error, spread);

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pizarra::vision {

// The standard deviation of a normal distribution, for each median of the errors' sizes.
inline constexpr double deviations_of_median = 1.4826;

// The upper one of two; 0 of nothing.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

// 1 for no error, 0 from 4.7 standard deviations on: 95 % efficient where errors are normal (J. W. Tukey's biweight).
inline double tukey_weight(double error, double spread) {
  constexpr double biweight = 4.685;
  const double part = error / (biweight * spread);
  return part * part >= 1 ? 0 : (1 - part * part) * (1 - part * part);
}

}  // namespace pizarra::vision
