#include "drivers/simulation/render/visibility.hpp"

#include <algorithm>

#include "drivers/simulation/render/paint_order.hpp"

namespace pizarra::simulation {

namespace {

struct Mask {
  int width;
  int height;
  std::vector<int> ids;
  void fill(int y, Span span, int id) {
    if (y < 0 || y >= height) return;
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (int x = std::max(0, span.first); x <= std::min(width - 1, span.last); ++x) {
      ids[row + static_cast<std::size_t>(x)] = id;
    }
  }
};

// How many pixels each number has, from 0 to the highest that there is.
std::vector<int> pixels_by_id(const Mask& mask) {
  std::vector<int> pixels(1);
  for (const int id : mask.ids) {
    const auto index = static_cast<std::size_t>(id);
    if (index >= pixels.size()) pixels.resize(index + 1);
    ++pixels[index];
  }
  return pixels;
}

struct Rows {
  int top;
  int bottom;
};

// Calls back with every row's spans of a decal, without overlaps.
template <class Use>
void for_spans(const SeenDecal& decal, Rows rows, Use use) {
  for (int y = rows.top; y < rows.bottom; ++y) {
    int done = -1'000'000;
    std::vector<Span> spans;
    for (const Outline& part : decal.parts) {
      const Span span = part.span(y, 0);
      if (!span.empty()) spans.push_back(span);
    }
    std::ranges::sort(spans, {}, &Span::first);
    for (Span span : spans) {
      span.first = std::max(span.first, done + 1);
      if (span.empty()) continue;
      use(y, span);
      done = span.last;
    }
  }
}

// The pixels of a face that the border of the image cuts off.
int cut_off(const Eye& eye, const Outline& face, Rows rows) {
  int pixels = 0;
  for (int y = rows.top; y < rows.bottom; ++y) {
    const Span span = face.span(y, 0);
    if (span.empty()) continue;
    pixels += span.last - span.first + 1;
    const int shown = std::min(span.last, eye.width - 1) - std::max(span.first, 0) + 1;
    if (y >= 0 && y < eye.height) pixels -= std::max(0, shown);
  }
  return pixels;
}

}  // namespace

std::vector<MarkView> seen_marks(const Eye& eye, const std::vector<Solid>& solids) {
  std::vector<SeenSolid> seen;
  for (const Solid& solid : solids) seen.push_back(see(eye, solid));
  Mask mask{eye.width, eye.height, std::vector<int>(static_cast<std::size_t>(eye.width * eye.height))};
  for (const std::size_t index : paint_order(eye, solids, seen)) {
    const Rows rows{seen[index].rect.top, seen[index].rect.bottom};
    for (int y = rows.top; y < rows.bottom; ++y) mask.fill(y, seen[index].silhouette.span(y, 0), 0);
    for (const SeenFace& face : seen[index].faces) {
      for (const SeenDecal& decal : face.decals) {
        for_spans(decal, rows, [&](int y, Span span) { mask.fill(y, span, decal.id); });
      }
    }
  }
  const std::vector<int> pixels = pixels_by_id(mask);
  std::vector<MarkView> marks;
  for (const SeenSolid& solid : seen) {
    const Rect whole = rect_around(solid.corners);
    for (const SeenFace& face : solid.faces) {
      for (const SeenDecal& decal : face.decals) {
        if (decal.id == 0) continue;
        MarkView mark{.id = decal.id};
        const Rows rows{std::max(whole.top, -eye.height), std::min(whole.bottom, 2 * eye.height)};
        for_spans(decal, rows, [&](int y, Span span) {
          const int count = span.last - span.first + 1;
          mark.all_pixels += count;
          mark.centre_px += count * Eigen::Vector2d((span.first + span.last) / 2.0, y);
        });
        if (mark.all_pixels == 0) continue;
        mark.centre_px /= mark.all_pixels;
        mark.all_pixels += cut_off(eye, face.outline, rows);
        const auto id = static_cast<std::size_t>(decal.id);
        mark.pixels = id < pixels.size() ? pixels[id] : 0;
        marks.push_back(mark);
      }
    }
  }
  return marks;
}

}  // namespace pizarra::simulation
