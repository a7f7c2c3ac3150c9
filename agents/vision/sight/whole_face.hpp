#pragma once

// How large the face of a mark is that a pair of cameras follows: as it would look from the front, whichever way it is
// turned and however far away it is. No motion changes that; what lies over a part of the mark does, in one image or in
// both. So a pair knows a covered face from a turned one by a single look, where one image goes by how the centre
// moves (continuity.hpp).
//
//   WholeFace whole(face_size(model, left, right, front_slimness(object)), left);
//   const FaceSize now = face_size(model, now_left, now_right, front_slimness(object));
//   if (whole.is_more_than(now, now_left)) ...
//   const double off = whole.may_be_off_px(now, now_left);
//   whole.follow(now, now_left);        // once it is taken for the mark
//
// What is remembered is the largest look, however long ago, for what covers a mark may come slowly and rest. It is the
// less sure the farther the mark has gone since: no calibration is the same everywhere. One look alone is not
// remembered, but what many have in common.

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/sight/stereo.hpp"

namespace pizarra {

// What the mark's standard deviations would be from the front.
struct FaceSize {
  struct Reading {
    double value;
    double spread;  // how far it may be off, as a part of it: a standard deviation
  };
  Reading area_mm2;   // the product of both principal ones
  Reading height_mm;  // along y: a turn about the vertical does not change it, and one about the horizontal is known
  // By how much a tilt about the horizontal makes both more than they look: what covers a part along a slanted edge
  // hides more from one camera than from the other, as a tilt does.
  double area_by_tilt;
  double height_by_tilt;
  double contrast;  // grey levels, of both images
  // How wide it looks in either image, as a part of how high; turns about the vertical change that, and both apart.
  double left_aspect;
  double right_aspect;
  double disparity_px;
};

// `front_slimness`: of the mark from the front; what is slim gets higher or lower as it turns in the image.
FaceSize face_size(const StereoModel& model, const SeenMark& left, const SeenMark& right, double front_slimness);

// The same of a mark that was not seen before, by the sizes with which the object was learned, or by its
// form where one of them is not known.
double may_be_off_px(const LearnedObject& object, const FaceSize& now, const SeenMark& left);

class WholeFace {
 public:
  WholeFace(const FaceSize& size, const SeenMark& left);

  // Clearly, by what noise makes.
  bool is_more_than(const FaceSize& now, const SeenMark& left) const;
  // Whichever way it moved: no part of it can be covered that would put the centre farther off than that.
  bool is_as_large(const FaceSize& now, const SeenMark& left, double most_off_px) const;
  // How far the centre may be off in the left image if all that is missing were covered, but for what noise makes; and
  // all by which it looks narrower, unless it looks turned and as near as it should.
  double may_be_off_px(const FaceSize& now, const SeenMark& left) const;
  void follow(const FaceSize& now, const SeenMark& left);

 private:
  FaceSize foreseen(const SeenMark& left) const;
  // How far a length may be off since the largest look, as a part of it.
  double drifted(const SeenMark& left) const;
  // How far it may be off beside the one remembered, which was seen in its own way.
  FaceSize compared(FaceSize now) const;

  FaceSize recent_;
  FaceSize largest_;
  cv::Point2d largest_at_;
  cv::Point2d recent_at_;
};

}  // namespace pizarra
