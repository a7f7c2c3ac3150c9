#pragma once

// The plane of a face that a pair of cameras sees, and what its mark looks like from the front. The plane shows in how
// the mark is squeezed and sheared from one image to the other.
//
//   const FacePlane plane = face_plane(model, left, right);
//   const FrontView front = view_from_front(model, plane, left);
//   const double yaw = yaw_deg(plane);

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/sight/stereo.hpp"

namespace pizarra::vision {

// Of a plane 1 / Z is linear in the image, so the disparity is: d = d0 + a x + b y, and the plane's normal is
// (a, b, (d - a x - b y) / f), x and y from the principal point. The right image of a mark is the left one squeezed by
// 1 - a along x and sheared by -b; second moments say both.
struct FacePlane {
  double across;  // the normal
  double down;
  double ahead;
  double across_spread;  // a standard deviation
  double down_spread;
  // Where in the left image, as slopes off the axis.
  double x;
  double y;
  double along_sight;  // d / f: so much of the normal is along the line of sight

  double normal2() const { return across * across + down * down + ahead * ahead; }
  // What of a round mark's height the image shows: one that is turned about both axes is higher than its tilt about the
  // horizontal alone would make it.
  double shown_height() const;
};
FacePlane face_plane(const camera::StereoModel& model, const SeenMark& left, const SeenMark& right);

// How far the face is turned from facing along the optical axis, degrees, positive where it looks to the right; good to
// a few degrees, so worth averaging.
double yaw_deg(const FacePlane& plane);

// What a mark would be from the front.
struct FrontView {
  double area_mm2;  // the product of both principal standard deviations
  double slimness;
  // Where the longer axis lies in the picture, degrees from right to down, more than 0 and at most 180.
  double axis_deg;
};
// `to_image`: px in the image for each standard deviation of the mark, from a picture in which that is the same in all
// directions.
FrontView view_from_front(const camera::StereoModel& model, const FacePlane& plane, const cv::Matx22d& to_image);
// Of a face that is parallel to the image.
FrontView view_as_seen(const cv::Matx22d& to_image, double mm_per_px);
// By its second moments, from a picture that is not turned against the image.
cv::Matx22d to_image_of(const SeenMark& seen);

}  // namespace pizarra::vision
