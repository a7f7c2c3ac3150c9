#pragma once

// The measures of one mark in one image: its place to a few hundredths of a pixel, and its shape; and, for learning,
// the rest of the thesis' Table C.1 and its picture.
//
//   std::optional<SeenMark> mark = measure_mark(cut, contour, MarkTone::dark);
//   std::optional<MarkPortrait> portrait = portray_mark(cut, mark->contour, mark->tone);

#include <array>
#include <optional>

#include "agents/vision/image/look.hpp"
#include "agents/vision/marks/mark_patch.hpp"
#include "agents/vision/marks/mark_signature.hpp"
#include "agents/vision/marks/tag.hpp"

namespace pizarra::vision {

struct SeenMark {
  MarkTone tone = MarkTone::dark;
  bool flattened = false;       // its signature is one from the front, its tilt undone (plane_look.hpp)
  std::optional<Tag> tag = {};  // where it is one; its shape then says nothing
  // Of a tag, to a fraction of a pixel, clockwise from its own upper left one.
  std::array<cv::Point2f, 4> corners{};
  double tag_doubt = 0;   // how far its corners are off by its cells, as a part of what is let pass
  cv::Point2d centre;     // grey-weighted, px
  cv::Rect box;           // around its contour
  double area_px = 0;     // filled pixels
  int perimeter_px = 0;   // contour pixels
  double width_px = 0;    // standard deviation along x
  double height_px = 0;   // standard deviation along y, which a yawed face keeps
  double slant_px2 = 0;   // covariance of x and y
  double slimness = 0;    // the smaller over the larger principal standard deviation
  double roundness = 0;   // 1 for a disc, more for any other shape; no view changes it
  double mark_level = 0;  // grey levels of the mark and of the ground around it
  double ground_level = 0;
  double noise = 0;     // of the levels it was measured from, a standard deviation
  double focal_px = 0;  // of the camera that shows it, where that is known
  MarkSignature signature;
  MarkContour contour;
};

// Its places are those of the cut. Nothing where MarkPatch::cut() finds none.
std::optional<SeenMark> measure_mark(const ImageCut& cut, MarkContour contour, MarkTone tone);

// How many times as light as the other the lighter one of the mark and its ground is, up to twenty, as a logarithm. No
// shadow changes it; a lamp's reflection makes it less.
double print_contrast(const SeenMark& mark);

// How far noise may move its centre along x, as a standard deviation in px, in an image of this noise. The centre is
// the mean of columns, each pixel weighted by how far it is from the ground's level. So noise of one sigma a pixel
// moves it by sigma sqrt(sum of (x - centre)^2) / (sum of weights). This is the propagation of uncertainty to first
// order (JCGM 100:2008, 5.1.2). Of a large mark only the pixels along its edge are weighed. A tag's centre goes with
// its corners: measured.
double centre_noise_px(const SeenMark& mark, double noise);
// And with what the pixels' phase and the light's slope add besides, as it was measured of marks in any light.
double centre_spread_px(const SeenMark& mark, double noise);

// The same mark where its image is a part of another one that begins at `origin`.
void move_by(SeenMark& mark, cv::Point origin);

struct MarkPortrait {
  int corners = 0;  // NF
  // Hu's first three moment invariants, scaled: 2 pi h1 (1 for a disc), 1e6 h2, 1e9 h3.
  std::array<double, 3> moments{};
  cv::Mat1f picture;  // template_picture()
};

std::optional<MarkPortrait> portray_mark(const ImageCut& cut, const MarkContour& contour, MarkTone tone);

// The number of places where the contour turns by more than 50 degrees within a few pixels.
int count_corners(const MarkContour& contour);

}  // namespace pizarra::vision
