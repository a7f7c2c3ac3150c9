#pragma once

// Whether what is measured all around a mark is one but for the light's slope: a plane, with a step to one side.
//
//   Around around{};
//   around[part] += {1, at, level};              // so many samples, each at its place
//   step_doubt(around, contrast, noise)          // from 1 on that side is another than the rest

#include <array>
#include <cstddef>
#include <opencv2/core.hpp>

namespace pizarra::vision {

// Of samples: how many, the sum of their places, px from the mark's middle, and of their levels.
struct LevelSamples {
  double count = 0;
  cv::Point2d at = {};
  double level = 0;

  cv::Vec3d row() const { return {count, at.x, at.y}; }
  LevelSamples& operator+=(const LevelSamples& other) {
    count += other.count;
    at += other.at;
    level += other.level;
    return *this;
  }
};

// Each part of a mark's outline is as long as the others.
inline constexpr std::size_t around_parts = 24;
using Around = std::array<LevelSamples, around_parts>;

// Takes the light's slope away, the plane that fits best, and gives the inverse of its normal matrix.
cv::Matx33d flatten(Around& all);

// By how much one side differs from the others, as a part of what noise, print and the light's slope may make of it.
// `noise` is that of the image.
double step_doubt(Around beyond, double contrast, double noise);

// The variance of a level that is measured between pixels, in an image of that noise.
double variance_between_pixels(double noise);

}  // namespace pizarra::vision
