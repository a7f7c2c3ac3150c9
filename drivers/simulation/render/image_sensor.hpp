#pragma once

// The effects of lens and sensor on a painted image: blur, the light's gradient, noise, eight bits.
//
// Noise comes from a field drawn once. Every frame and side reads it from an offset of its own. So a frame's noise
// depends on its number alone, not on the frames that were asked for before.
//
//   sensor.expose(canvas, rect, exposure);
//   const Image image = sensor.develop(exposure, canvas, frame, Side::left);

#include "blackboard/stream.hpp"
#include "blackboard/time/random.hpp"
#include "drivers/simulation/render/canvas.hpp"

namespace pizarra::simulation {

// Grey levels times 16, before noise.
struct Exposure {
  Exposure(const Canvas& canvas) : samples(canvas.pixels.size()) {}
  std::vector<std::int16_t> samples;
};

class ImageSensor {
 public:
  ImageSensor(const CameraConfig& camera, const Random& random);

  // The part of the canvas that must be painted for `rect` to be exposed.
  Rect needed(const Rect& rect) const { return rect.grown(reach); }
  // Blurs and lights the canvas within `rect` into the exposure.
  void expose(const Canvas& canvas, const Rect& rect, Exposure& exposure);
  Image develop(const Exposure& exposure, const Canvas& like, std::uint64_t frame, Side side) const;

 private:
  static constexpr int reach = 2;  // of the blur, px

  void blur_rows(const Canvas& canvas, const Rect& rect);

  std::vector<float> kernel_;
  // From grey levels to exposure, for every sample.
  std::vector<float> grey_light_;
  std::vector<float> colour_light_;
  std::vector<float> rows_;  // blurred along the rows only
  std::vector<std::int16_t> noise_;
  Random offsets_;
};

}  // namespace pizarra::simulation
