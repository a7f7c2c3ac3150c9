#pragma once

// The outline of a learned mark registered with an image: the homography of its plane, by the image's edges along the
// outline's normals. Light may differ from one part of the mark to another: every edge is measured by itself.
//
//   std::optional<PlaneFit> fit = fit_plane(image, outline, affine_start(seen_reach, outline.reach, turn),
//   MarkTone::dark); fit->to_image * (u, v, 1)            // a place of the mark, in standard deviations, to pixels
//
// Each edge is the centroid of the grey levels' change around its steepest place, so that neither blur nor motion moves
// it where the border is straight; near corners it is left out. A few Gauss-Newton steps with the homography's own
// derivatives, each edge weighted by how far it is off (J. W. Tukey's biweight). A prior holds what a circle leaves
// open, and bounds the perspective: no mark is as near as that.

#include <cmath>
#include <limits>

#include "agents/vision/marks/mark_patch.hpp"
#include "agents/vision/marks/plane_outline.hpp"
#include "agents/vision/marks/rigid_plane.hpp"

namespace pizarra::vision {

struct PlaneEdge {
  bool found = false;
  std::size_t point = 0;  // of the outline
  cv::Point2d at;         // px; on an arc where it would be without blur
  cv::Vec2d normal;       // of the border where it was expected, out of the mark
  double off_px = 0;      // along the normal, from where the fit puts the border
  double inner = 0;       // grey levels on either side
  double outer = 0;
  bool is_border = false;    // supports the fit
  bool counts = false;       // far enough from corners to be measured
  bool measures = false;     // and the fit goes by it
  bool is_straight = false;  // so far from every bend that no blur moves it
};

struct PlaneFit {
  cv::Matx33d to_image;
  std::vector<PlaneEdge> edges;  // of the outline's points, in their order
  double rms_px = 0;             // of the edges that support it
  double supported = 0;          // the part of the outline that edges support, 0 to 1
  double middle_spread_px = 0;   // of the mark's centroid: a standard deviation, by the edges' scatter

  cv::Point2d in_image(const cv::Vec2d& plane) const;
  // How places near the mark's centroid move: px a standard deviation.
  cv::Matx22d slope() const { return slope_at({0, 0}); }
  cv::Matx22d slope_at(const cv::Vec2d& plane) const;
  // How many px a standard deviation of the mark is, by the area that it covers.
  double size_px() const { return std::sqrt(std::abs(cv::determinant(slope()))); }
};

// The map between the two reaches, the seen one turned by so many of Reach::turns.
cv::Matx33d affine_start(const Reach& seen, const Reach& learned, int turn);

// How much of the outline is there, and how near the start is.
struct PlaneSearch {
  int most_reach_px;
  double least_found;  // of the edges
  // How much of itself the image of a part may be slanted, which says less of that than a whole: a standard deviation.
  double usual_slant;
  int steps = 6;
  std::size_t every = 1;           // of the outline's points
  bool knows_perspective = false;  // the start does
};
inline constexpr PlaneSearch for_whole{12, 0.5, std::numeric_limits<double>::infinity()};
inline constexpr PlaneSearch for_part{4, 0.35, 0.05};
// From one frame to the next, before one camera and a pair, and from the left image of a pair to the right one.
inline constexpr PlaneSearch to_follow_alone{4, 0.5, std::numeric_limits<double>::infinity(), 1, 1, true};
inline constexpr PlaneSearch to_follow{4, 0.5, std::numeric_limits<double>::infinity(), 1, 3, true};
inline constexpr PlaneSearch to_follow_in_right{4, 0.5, std::numeric_limits<double>::infinity(), 2, 3, true};

// Nothing where fewer edges are there.
std::optional<PlaneFit> fit_plane(const cv::Mat1b& image, const PlaneOutline& outline, const cv::Matx33d& start,
                                  MarkTone tone, const PlaneSearch& search = for_whole, const PlaneLens& lens = {});
// The same by the edges alone that are its border by now (PlaneEdge::is_border).
std::optional<PlaneFit> fit_to_border(const cv::Mat1b& image, const PlaneOutline& outline, const PlaneFit& fit,
                                      MarkTone tone, const PlaneSearch& search, const PlaneLens& lens = {});

}  // namespace pizarra::vision
