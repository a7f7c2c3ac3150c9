#include "drivers/simulation/render/visibility.hpp"

#include <algorithm>

#include "drivers/simulation/render/paint_order.hpp"

namespace pizarra::simulation {

namespace {

// Which mark each pixel shows, and how many pixels show each.
class Mask {
 public:
  Mask(int width, int height)
      : width_(width),
        ids_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        shows_marks_(static_cast<std::size_t>(height)) {}

  // 0 is no mark. A row without marks stays as it is then.
  bool changes(int y, int id) const {
    return y >= 0 && y < static_cast<int>(shows_marks_.size()) &&
           (id != 0 || shows_marks_[static_cast<std::size_t>(y)]);
  }
  void fill(int y, Span span, int id) {
    if (!changes(y, id)) return;
    const auto row = static_cast<std::size_t>(y);
    shows_marks_[row] = true;
    const auto begin = ids_.begin() + static_cast<std::ptrdiff_t>(row) * width_;
    int* const painted = &count(id);
    for (int x = std::max(0, span.first); x <= std::min(width_ - 1, span.last); ++x) {
      int& shown = begin[x];
      --pixels_[static_cast<std::size_t>(shown)];
      ++*painted;
      shown = id;
    }
  }
  int pixels(int id) const {
    const auto index = static_cast<std::size_t>(id);
    return index < pixels_.size() ? pixels_[index] : 0;
  }

 private:
  int& count(int id) {
    const auto index = static_cast<std::size_t>(id);
    if (index >= pixels_.size()) pixels_.resize(index + 1);
    return pixels_[index];
  }

  const int width_;
  std::vector<int> ids_;
  std::vector<bool> shows_marks_;  // each row
  std::vector<int> pixels_ = {0};  // by id
};

struct Rows {
  int top;
  int bottom;
};

// Calls back with every row's spans of a decal, without overlaps.
template <class Use>
void for_spans(const SeenDecal& decal, Rows rows, Use use) {
  std::vector<Span> spans;
  for (int y = rows.top; y < rows.bottom; ++y) {
    int done = -1'000'000;
    spans.clear();
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
  Mask mask(eye.width, eye.height);
  for (const std::size_t index : paint_order(eye, solids, seen)) {
    const Rows rows{seen[index].rect.top, seen[index].rect.bottom};
    for (int y = rows.top; y < rows.bottom; ++y) {
      if (mask.changes(y, 0)) mask.fill(y, seen[index].silhouette.span(y, 0), 0);
    }
    for (const SeenFace& face : seen[index].faces) {
      for (const SeenDecal& decal : face.decals) {
        for_spans(decal, rows, [&](int y, Span span) { mask.fill(y, span, decal.id); });
      }
    }
  }
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
        mark.pixels = mask.pixels(decal.id);
        marks.push_back(mark);
      }
    }
  }
  return marks;
}

}  // namespace pizarra::simulation
