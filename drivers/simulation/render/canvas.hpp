#pragma once

// Anti-aliased painting of seen solids into an image of floats, grey or colour, within a rectangle.
//
//   Canvas canvas(320, 240, 3);
//   paint(canvas, solid, rect);
//   shade(canvas, outline, 0.3F, 2, rect);     // darken by a soft shadow

#include <vector>

#include "drivers/simulation/render/seen_solid.hpp"

namespace pizarra::simulation {

struct Canvas {
  Canvas(int width_px, int height_px, int channel_count)
      : width(width_px),
        height(height_px),
        channels(channel_count),
        pixels(static_cast<std::size_t>(width_px * height_px * channel_count)) {}
  float* at(int x, int y) { return pixels.data() + (y * width + x) * channels; }
  const float* at(int x, int y) const { return pixels.data() + (y * width + x) * channels; }
  Rect rect() const { return {0, 0, width, height}; }

  int width;
  int height;
  int channels;  // 1 grey, 3 blue green red
  std::vector<float> pixels;
};

// The eye's weights of blue, green and red (ITU-R BT.601).
float grey_of(const Colour& colour);

void paint(Canvas& canvas, const SeenSolid& solid, const Rect& within);
// What of the photograph lies inside the outline.
void paint(Canvas& canvas, const SeenPhotograph& photograph, const Outline& border, const Rect& within);
// One flat convex polygon.
void paint(Canvas& canvas, const Outline& outline, const Colour& colour, const Rect& within);
// Takes away `dark` (0..1) of the light inside, fading over `softness_px` around the edge.
void shade(Canvas& canvas, const Outline& outline, float dark, double softness_px, const Rect& within);

// The same inside any of them, sharply: where they lie over each other it is no darker.
void shade(Canvas& canvas, const std::vector<Outline>& outlines, float dark, const Rect& within);

}  // namespace pizarra::simulation
