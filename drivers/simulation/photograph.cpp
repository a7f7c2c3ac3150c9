#include "drivers/simulation/photograph.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::simulation {

namespace {

constexpr int bgr_channels = 3;

int mirrored(int index, int size) {
  const int period = 2 * size;
  const int within = ((index % period) + period) % period;
  return within < size ? within : period - 1 - within;
}

const std::uint8_t* pixel(const Image& image, int x, int y) {
  const int index = (mirrored(y, image.height) * image.width + mirrored(x, image.width)) * bgr_channels;
  return image.pixels.data() + index;
}

Image halved(const Image& image) {
  Image half{std::max(1, image.width / 2), std::max(1, image.height / 2), bgr_channels, {}};
  half.pixels.reserve(image.pixels.size() / 4);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < bgr_channels; ++c) {
        const int sum = pixel(image, 2 * x, 2 * y)[c] + pixel(image, 2 * x + 1, 2 * y)[c] +
                        pixel(image, 2 * x, 2 * y + 1)[c] + pixel(image, 2 * x + 1, 2 * y + 1)[c];
        half.pixels.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

Eigen::Vector3f colour_of(const std::uint8_t* bgr) {
  return Eigen::Map<const Eigen::Vector3<std::uint8_t>>(bgr).cast<float>();
}

// Between the four pixels around.
Eigen::Vector3f between(const Image& image, double right, double down) {
  const double x = right - 0.5;
  const double y = down - 0.5;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const auto part_right = static_cast<float>(x - left);
  const auto part_down = static_cast<float>(y - top);
  const auto row = [&](int at) {
    const Eigen::Vector3f from = colour_of(pixel(image, left, at));
    return Eigen::Vector3f(from + part_right * (colour_of(pixel(image, left + 1, at)) - from));
  };
  const Eigen::Vector3f upper = row(top);
  return upper + part_down * (row(top + 1) - upper);
}

}  // namespace

Photograph::Photograph(Image image) {
  levels_.push_back(std::move(image));
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
}

Eigen::Vector3f Photograph::at(double right, double down, double pixels) const {
  const auto halvings = static_cast<std::size_t>(std::log2(std::clamp(pixels, 1.0, 1e6)));
  const Image& level = levels_[std::min(halvings, levels_.size() - 1)];
  // So far away that its place in it means nothing.
  constexpr double farthest = 1e8;
  const double x = std::clamp(right, -farthest, farthest) * level.width / width();
  const double y = std::clamp(down, -farthest, farthest) * level.height / height();
  return between(level, x, y);
}

}  // namespace pizarra::simulation
