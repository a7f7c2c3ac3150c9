#pragma once

// A mark cut out of its image: how far each pixel is from the ground's level towards the mark's. Everything that is
// measured of a mark is measured here.
//
//   MarkPatch patch;
//   if (patch.cut(image, contour, MarkTone::dark)) centre_of(patch) ...

#include "agents/vision/image/contour.hpp"

namespace pizarra {

enum class MarkTone : std::uint8_t { dark, light };  // the mark's, on the opposite ground

struct MarkPatch {
  static constexpr int most_side_px = 128;  // margins included
  static constexpr int margin_px = 3;

  // False where the region is no solid mark on even ground: cut by the image's edge, too large, full of holes or of
  // other tones, touched by something, or of too little contrast.
  bool cut(const cv::Mat1b& image, const MarkContour& contour, MarkTone tone);

  const std::int16_t* row(int y) const { return values.data() + y * stride; }

  cv::Rect box;  // in the image; its outermost pixels are 0
  int stride = 0;
  int area_px = 0;  // enclosed by the contour
  int mark_level = 0;
  int ground_level = 0;
  int contrast = 0;  // their distance
  // Row by row, `contrast` where the mark is, 0 where the ground is, in between where an edge crosses a pixel. Not
  // clamped: noise must not add weight. What lies two pixels outside and is yet unlike the ground belongs to something
  // else. A light gradient moves the centre a little, by the same in both images (0.06 px at 30 % over the image's
  // width); fitting the light per mark would cost more in depth than it gains.
  std::array<std::int16_t, most_side_px * most_side_px> values;

 private:
  template <int words>
  bool cut_rows(const cv::Mat1b& image, const MarkContour& contour, MarkTone tone);
};

}  // namespace pizarra
