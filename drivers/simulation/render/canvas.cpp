#include "drivers/simulation/render/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pizarra::simulation {

namespace {

constexpr std::size_t most_faces = 32;  // seen at once of one solid

template <int channels>
std::array<float, channels> tone_of(const Colour& colour) {
  if constexpr (channels == 1) {
    return {grey_of(colour)};
  } else {
    return {colour.x(), colour.y(), colour.z()};
  }
}

template <int channels>
void blend(float* pixel, const std::array<float, channels>& tone, float cover) {
  for (int c = 0; c < channels; ++c) pixel[c] += cover * (tone[static_cast<std::size_t>(c)] - pixel[c]);
}

Span clipped(Span span, const Rect& within) {
  return {std::max(span.first, within.left), std::min(span.last, within.right - 1)};
}

template <int channels>
void fill(Canvas& canvas, int y, Span span, const std::array<float, channels>& tone) {
  for (int x = span.first; x <= span.last; ++x) std::copy(tone.begin(), tone.end(), canvas.at(x, y));
}

template <int channels>
void paint_outline(Canvas& canvas, const Outline& outline, const Colour& colour, const Rect& within) {
  const auto tone = tone_of<channels>(colour);
  for (int y = within.top; y < within.bottom; ++y) {
    const Span outer = clipped(outline.span(y, -0.5), within);
    if (outer.empty()) continue;
    const Span inner = clipped(outline.span(y, 0.5), within);
    for (int x = outer.first; x <= outer.last; ++x) {
      if (!inner.empty() && x == inner.first) {
        fill<channels>(canvas, y, inner, tone);
        x = inner.last;
        continue;
      }
      blend<channels>(canvas.at(x, y), tone, outline.coverage(x, y));
    }
  }
}

// The colour where faces meet: each as far as the pixel lies on its side of the seams.
template <int channels>
std::array<float, channels> mixed_tone(const SeenSolid& solid, int x, int y) {
  std::array<float, channels> mixed{};
  float sum = 0;
  for (const SeenFace& face : solid.faces) {
    const float weight = std::max(1e-4F, face.seams.coverage(x, y));
    const auto tone = tone_of<channels>(face.colour);
    for (std::size_t c = 0; c < channels; ++c) mixed[c] += weight * tone[c];
    sum += weight;
  }
  for (float& tone : mixed) tone /= sum;
  return mixed;
}

template <int channels>
void paint_row(Canvas& canvas, const SeenSolid& solid, int y, Span outer, const Rect& within) {
  std::array<Span, most_faces> inner;
  std::size_t count = 0;
  for (const SeenFace& face : solid.faces) {
    const Span span = clipped(face.outline.span(y, 0.5), within);
    if (span.empty() || count == most_faces) continue;
    fill<channels>(canvas, y, span, tone_of<channels>(face.colour));
    inner[count++] = span;
  }
  std::sort(inner.begin(), inner.begin() + static_cast<std::ptrdiff_t>(count),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  int x = outer.first;
  for (std::size_t i = 0; i <= count; ++i) {
    const int until = i < count ? std::min(inner[i].first - 1, outer.last) : outer.last;
    for (; x <= until; ++x) {
      blend<channels>(canvas.at(x, y), mixed_tone<channels>(solid, x, y), solid.silhouette.coverage(x, y));
    }
    if (i < count) x = std::max(x, inner[i].last + 1);
  }
}

// The light cells on the dark square of a tag.
template <int channels>
void paint_cells(Canvas& canvas, const SeenCells& cells, const Outline& square, const Colour& colour,
                 const Rect& within) {
  const auto tone = tone_of<channels>(colour);
  for (int y = within.top; y < within.bottom; ++y) {
    const Span span = clipped(square.span(y, -0.5), within);
    for (int x = span.first; x <= span.last; ++x) blend<channels>(canvas.at(x, y), tone, cells.light(x, y));
  }
}

template <int channels>
void paint_photograph(Canvas& canvas, const SeenPhotograph& photograph, const Outline& border, const Rect& within) {
  for (int y = within.top; y < within.bottom; ++y) {
    const Span span = clipped(border.span(y, -0.5), within);
    for (int x = span.first; x <= span.last; ++x) {
      if (!photograph.is_ahead(x, y)) continue;
      blend<channels>(canvas.at(x, y), tone_of<channels>(photograph.at(x, y)), border.coverage(x, y));
    }
  }
}

template <int channels>
void paint_solid(Canvas& canvas, const SeenSolid& solid, const Rect& within) {
  const Rect area = solid.rect.intersected(within);
  for (int y = area.top; y < area.bottom; ++y) {
    const Span outer = clipped(solid.silhouette.span(y, -0.5), area);
    if (!outer.empty()) paint_row<channels>(canvas, solid, y, outer, area);
  }
  for (const SeenFace& face : solid.faces) {
    if (face.photograph) paint_photograph<channels>(canvas, *face.photograph, face.outline, area);
    for (const SeenDecal& decal : face.decals) {
      for (const Outline& part : decal.parts) paint_outline<channels>(canvas, part, decal.colour, area);
      if (decal.cells) paint_cells<channels>(canvas, *decal.cells, decal.parts.front(), face.colour, area);
    }
    if (!face.shadows.empty()) shade(canvas, face.shadows, face.shadow_dark, area);
  }
}

}  // namespace

float grey_of(const Colour& colour) { return 0.114F * colour.x() + 0.587F * colour.y() + 0.299F * colour.z(); }

void paint(Canvas& canvas, const SeenSolid& solid, const Rect& within) {
  if (canvas.channels == 1) {
    paint_solid<1>(canvas, solid, within);
  } else {
    paint_solid<3>(canvas, solid, within);
  }
}

void paint(Canvas& canvas, const SeenPhotograph& photograph, const Outline& border, const Rect& within) {
  if (canvas.channels == 1) {
    paint_photograph<1>(canvas, photograph, border, within);
  } else {
    paint_photograph<3>(canvas, photograph, border, within);
  }
}

void paint(Canvas& canvas, const Outline& outline, const Colour& colour, const Rect& within) {
  if (canvas.channels == 1) {
    paint_outline<1>(canvas, outline, colour, within);
  } else {
    paint_outline<3>(canvas, outline, colour, within);
  }
}

void shade(Canvas& canvas, const Outline& outline, float dark, double softness_px, const Rect& within) {
  for (int y = within.top; y < within.bottom; ++y) {
    const Span span = clipped(outline.span(y, -softness_px), within);
    for (int x = span.first; x <= span.last; ++x) {
      const double part = std::clamp(0.5 + outline.distance(x, y) / (2 * softness_px), 0.0, 1.0);
      const float keep = 1 - dark * static_cast<float>(part * part * (3 - 2 * part));
      for (int c = 0; c < canvas.channels; ++c) canvas.at(x, y)[c] *= keep;
    }
  }
}

void shade(Canvas& canvas, const std::vector<Outline>& outlines, float dark, const Rect& within) {
  std::vector<float> shaded(static_cast<std::size_t>(canvas.width));  // how far each pixel of a row is
  for (int y = within.top; y < within.bottom; ++y) {
    Span all{canvas.width, -1};
    for (const Outline& outline : outlines) {
      const Span span = clipped(outline.span(y, -0.5), within);
      for (int x = span.first; x <= span.last; ++x) {
        float& of_pixel = shaded[static_cast<std::size_t>(x)];
        of_pixel = std::max(of_pixel, outline.coverage(x, y));
      }
      if (!span.empty()) all = {std::min(all.first, span.first), std::max(all.last, span.last)};
    }
    for (int x = all.first; x <= all.last; ++x) {
      float& of_pixel = shaded[static_cast<std::size_t>(x)];
      for (int c = 0; c < canvas.channels; ++c) canvas.at(x, y)[c] *= 1 - dark * of_pixel;
      of_pixel = 0;
    }
  }
}

}  // namespace pizarra::simulation
