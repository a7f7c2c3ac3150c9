#pragma once

// What is measured of one mark in one image: its place to a few hundredths of a pixel, the parameters of the thesis'
// Table C.1, and its shape.
//
//   std::optional<SeenMark> mark = measure_mark(grey, contour, MarkTone::dark);

#include <optional>

#include "agents/vision/contour.hpp"
#include "agents/vision/mark_signature.hpp"

namespace pizarra {

enum class MarkTone : std::uint8_t { dark, light };  // the mark's, on the opposite ground

struct SeenMark {
  MarkTone tone = MarkTone::dark;
  cv::Point2d centre;    // grey-weighted, px
  double area_px = 0;    // filled pixels
  int perimeter_px = 0;  // contour pixels
  int corners = 0;       // NF
  // Hu's first three moment invariants, scaled: 2 pi h1 (1 for a disc), 1e6 h2, 1e9 h3.
  std::array<double, 3> moments{};
  double width_px = 0;    // standard deviation along x
  double height_px = 0;   // standard deviation along y, which a yawed face keeps
  double slimness = 0;    // the smaller over the larger principal standard deviation
  double roundness = 0;   // as moments[0] after the second moments were made equal: no view changes it
  double mark_level = 0;  // grey levels of the mark and of the ground around it
  double ground_level = 0;
  WeightedShape shape;
  MarkSignature signature;
  MarkContour contour;
};

// Nothing where the region is no solid mark on even ground: cut by the image's edge, full of holes or of other tones,
// touched by something, or of too little contrast.
std::optional<SeenMark> measure_mark(const cv::Mat& grey, const MarkContour& contour, MarkTone tone);

// The number of places where the contour turns by more than 50 degrees within a few pixels.
int count_corners(const MarkContour& contour);

}  // namespace pizarra
