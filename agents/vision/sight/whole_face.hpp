#pragma once

// How large the face of a mark is that a pair of cameras follows: as it would look from the front, whichever way it is
// turned and however far away it is. No motion changes that; what lies over a part of the mark does, in one image or in
// both. So a pair knows a covered face from a turned one by a single look, where one image goes by how the centre
// moves (whole_mark.hpp).
//
//   WholeFace whole(face_size(model, left, right, front_slimness(object)), left);
//   const FaceSize now = face_size(model, now_left, now_right, front_slimness(object));
//   if (whole.is_more_than(now, now_left)) ...
//   const double off = whole.off_if_covered_px(now, now_left);
//   whole.follow(now, now_left);        // once it is taken for the mark
//
// The largest look is remembered, however long ago, for a cover may come slowly and rest. It is the less sure the
// farther the mark has gone since: no calibration is the same everywhere. Not one look alone is remembered, but what
// many have in common.

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/sight/stereo.hpp"

namespace pizarra::vision {

// The mark's standard deviations as they would be from the front.
struct FaceSize {
  struct Reading {
    double value;
    double spread;  // how far it may be off, as a part of it: a standard deviation
  };
  Reading area_mm2;  // the product of both principal ones, by the plane of the face
  Reading size_mm;   // the root of the same, by how each image alone shows it (unyawed.hpp)
  // By how much a tilt about the horizontal makes both more than they look: what covers a part along a slanted edge
  // hides more from one camera than from the other, as a tilt does.
  double area_by_tilt;
  double size_by_tilt;
  double tilt_deviations;  // of the tilt, from none
  double contrast;         // grey levels, of both images
  // How much of its width is to be seen in either image; turns about the vertical change that, and both apart.
  double left_shown;
  double right_shown;
  double disparity_px;
};

// `front_slimness`: of the mark from the front.
FaceSize face_size(const camera::StereoModel& model, const SeenMark& left, const SeenMark& right,
                   double front_slimness);

// Where it is covered rather than tilted.
FaceSize if_not_tilted(FaceSize size);

// How much of `whole` is missing, where it may be off by `slack` besides.
double missing(double whole, const FaceSize::Reading& now, double slack);

// A nearer cover over one side of the mark hides more from one camera than from the other. So the mark looks turned.
// But both centres come apart as well, by half as much, so that it looks too near and too small.
struct Narrowed {
  double off_px;     // how far the centre is off if it is covered
  double too_small;  // how much of its size is missing then
};
Narrowed narrowed(double left_shown, double right_shown, const FaceSize& now, const SeenMark& left);

class WholeFace {
 public:
  WholeFace(const FaceSize& size, const SeenMark& left);

  // Clearly, by what noise makes.
  bool is_more_than(const FaceSize& now, const SeenMark& left) const;
  // Whichever way it moved: no part of it can be covered that would put the centre farther off than that.
  bool is_as_large(const FaceSize& now, const SeenMark& left, double most_off_px) const;
  // How far the centre may be off in the left image if all that is missing were covered, but for what noise makes; and
  // all by which it looks narrower, unless it looks turned and as near as it should.
  double off_if_covered_px(const FaceSize& now, const SeenMark& left) const;
  void follow(const FaceSize& now, const SeenMark& left);

 private:
  FaceSize foreseen(const SeenMark& left) const;
  // How far a length may be off since the largest look, as a part of it.
  double drifted(const SeenMark& left) const;
  // How far it may be off beside the one remembered, which was seen in its own way.
  FaceSize compared(FaceSize now) const;

  FaceSize recent_;
  FaceSize largest_;
  // The same where it was not tilted but covered: what has always been tilted has not lost anything by that.
  FaceSize largest_if_not_tilted_;
  cv::Point2d largest_at_;
  cv::Point2d recent_at_;
};

}  // namespace pizarra::vision
