#pragma once

// A mark cut out of its image: how far each pixel is from the ground's level towards the mark's. Everything that is
// measured of a mark is measured here.
//
//   MarkPatch patch;
//   if (patch.cut(cut, contour, MarkTone::dark)) centre_of(patch) ...

#include "agents/vision/image/contour.hpp"
#include "agents/vision/image/look.hpp"

namespace pizarra::vision {

enum class MarkTone : std::uint8_t { dark, light };  // the mark's, on the opposite ground

// Wider or higher than 30 px: light changes across it.
bool is_large_mark(cv::Rect box);

struct MarkPatch {
  static constexpr int most_side_px = 128;  // margins included
  static constexpr int margin_px = 3;

  // False where the region is no solid mark on even ground: cut by the image's edge, full of holes or of other tones,
  // touched by something, or of too little contrast. A region larger than a patch is cut from a reduced image.
  // `contour` is of the pixels of `from`.
  bool cut(const ImageCut& from, const MarkContour& contour, MarkTone tone);

  const std::int16_t* row(int y) const { return values.data() + y * stride; }

  // From a place in the patch to the same in the image.
  cv::Point2d in_image(cv::Point2d place) const {
    const cv::Point2d half(0.5, 0.5);
    return cv::Point2d(origin) + (place + half) * reduction - half;
  }

  cv::Point origin;   // of its first pixel, in the image
  int reduction = 1;  // so many pixels of the image, along and across, are one of the patch
  cv::Size size;      // its outermost pixels are 0
  cv::Rect mark_box;  // around the contour, in the image
  int stride = 0;
  int area_px = 0;  // enclosed by the contour
  int mark_level = 0;
  int ground_level = 0;
  int contrast = 0;  // their distance
  // Row by row, `contrast` where the mark is, 0 where the ground is, in between where an edge crosses a pixel. Not
  // clamped: noise must not add weight. Pixels two or more outside that are unlike the ground belong to something else.
  // A light gradient moves the centre a little, by the same in both images (0.06 px at 30 % over the image's width);
  // fitting the light per mark would cost more in depth than it gains. Across a large mark light changes: it is divided
  // out, the mark's inside is `contrast` all over, and its edge alone tells where it is.
  std::array<std::int16_t, most_side_px * most_side_px> values;

 private:
  template <int words>
  struct Regions;
  template <int words>
  bool cut_rows(cv::Mat1b& pixels, const MarkContour& contour, cv::Point corner, MarkTone tone, double noise);
  template <int words>
  void even_light_out(cv::Mat1b& pixels, const Regions<words>& regions, MarkTone tone) const;
  // False where there is no clear mark on even ground.
  template <int words>
  bool measure_levels(const cv::Mat1b& pixels, const Regions<words>& regions, MarkTone tone, double noise);
  template <int words>
  void write_values(const cv::Mat1b& pixels, const Regions<words>& regions, MarkTone tone);
  template <int words>
  void fill_core(const Regions<words>& regions);
};

}  // namespace pizarra::vision
