#include "drivers/simulation/render/image_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace pizarra::simulation {

namespace {

constexpr int one_level = 16;
constexpr std::size_t noise_samples = 1 << 17;

std::vector<float> gauss(double sigma_px, int reach) {
  std::vector<float> kernel;
  float sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    const double weight = sigma_px > 0 ? std::exp(-i * i / (2 * sigma_px * sigma_px)) : (i == 0 ? 1.0 : 0.0);
    kernel.push_back(static_cast<float>(weight));
    sum += kernel.back();
  }
  for (float& weight : kernel) weight /= sum;
  return kernel;
}

// For every sample of an image of so many channels.
std::vector<float> gradient(const CameraConfig& camera, double direction, std::size_t channels) {
  const int width = camera.model.width;
  const int height = camera.model.height;
  std::vector<float> light;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double along = (2.0 * x / width - 1) * std::cos(direction) + (2.0 * y / height - 1) * std::sin(direction);
      light.insert(light.end(), channels, static_cast<float>(one_level * (1 + camera.light_gradient / 2 * along)));
    }
  }
  return light;
}

}  // namespace

ImageSensor::ImageSensor(const CameraConfig& camera, const Random& random)
    : kernel_(gauss(camera.blur_sigma_px, reach)), offsets_(random.split("frames")) {
  Random light = random.split("light");
  const double direction = light.uniform(0, 2 * std::numbers::pi);
  grey_light_ = gradient(camera, direction, 1);
  colour_light_ = gradient(camera, direction, 3);
  Random noise = random.split("noise");
  noise_.reserve(noise_samples);
  for (std::size_t i = 0; i < noise_samples; ++i) {
    noise_.push_back(static_cast<std::int16_t>(std::lround(noise.normal() * camera.noise_sigma * one_level)));
  }
}

void ImageSensor::blur_rows(const Canvas& canvas, const Rect& rect) {
  const int channels = canvas.channels;
  const int row = canvas.width * channels;
  const float far = kernel_[0];
  const float near = kernel_[1];
  const float centre = kernel_[2];
  const int first = rect.left * channels;
  const int last = rect.right * channels;
  const int safe_first = std::max(first, reach * channels);
  const int safe_last = std::min(last, row - reach * channels);
  rows_.resize(canvas.pixels.size());
  for (int y = rect.top; y < rect.bottom; ++y) {
    const float* from = canvas.pixels.data() + y * row;
    float* to = rows_.data() + y * row;
    // Beyond the image's border its last pixel goes on.
    const auto at_border = [&](int i) {
      float sum = 0;
      for (int k = -reach; k <= reach; ++k) {
        const int x = std::clamp(i / channels + k, 0, canvas.width - 1);
        sum += kernel_[static_cast<std::size_t>(k + reach)] * from[x * channels + i % channels];
      }
      return sum;
    };
    for (int i = first; i < std::min(safe_first, last); ++i) to[i] = at_border(i);
    for (int i = safe_first; i < safe_last; ++i) {
      to[i] = far * (from[i - 2 * channels] + from[i + 2 * channels]) +
              near * (from[i - channels] + from[i + channels]) + centre * from[i];
    }
    for (int i = std::max(safe_last, first); i < last; ++i) to[i] = at_border(i);
  }
}

void ImageSensor::expose(const Canvas& canvas, const Rect& rect, Exposure& exposure) {
  const Rect area = rect.intersected(canvas.rect());
  blur_rows(canvas, needed(area).intersected(canvas.rect()));
  const int row = canvas.width * canvas.channels;
  const float far = kernel_[0];
  const float near = kernel_[1];
  const float centre = kernel_[2];
  for (int y = area.top; y < area.bottom; ++y) {
    const auto source = [&](int k) { return rows_.data() + std::clamp(y + k, 0, canvas.height - 1) * row; };
    const float* up2 = source(-2);
    const float* up = source(-1);
    const float* here = source(0);
    const float* down = source(1);
    const float* down2 = source(2);
    std::int16_t* out = exposure.samples.data() + y * row;
    const float* light = (canvas.channels == 1 ? grey_light_ : colour_light_).data() + y * row;
    for (int i = area.left * canvas.channels; i < area.right * canvas.channels; ++i) {
      const float blurred = far * (up2[i] + down2[i]) + near * (up[i] + down[i]) + centre * here[i];
      out[i] = static_cast<std::int16_t>(blurred * light[i] + 0.5F);
    }
  }
}

Image ImageSensor::develop(const Exposure& exposure, const Canvas& like, std::uint64_t frame, Side side) const {
  Image image{like.width, like.height, like.channels, std::vector<std::uint8_t>(exposure.samples.size())};
  Random random = offsets_.split(fmt::format("{} {}", frame, side == Side::left ? "left" : "right"));
  std::size_t at = random.below(noise_samples);
  for (std::size_t done = 0; done < exposure.samples.size(); at = 0) {
    const std::size_t count = std::min(noise_samples - at, exposure.samples.size() - done);
    const std::int16_t* samples = exposure.samples.data() + done;
    const std::int16_t* noise = noise_.data() + at;
    std::uint8_t* out = image.pixels.data() + done;
    for (std::size_t i = 0; i < count; ++i) {
      const int level = (samples[i] + noise[i] + one_level / 2) >> 4;
      out[i] = static_cast<std::uint8_t>(std::clamp(level, 0, 255));
    }
    done += count;
  }
  return image;
}

}  // namespace pizarra::simulation
