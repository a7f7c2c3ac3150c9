#pragma once

// How large the face of a mark is that a pair of cameras follows: as it would look from the front, whichever way it is
// turned and however far away it is. No motion changes that; what lies over a part of the mark does, in one image or in
// both. So a pair knows a covered face from a turned one by a single look, where one image goes by how the centre
// moves (continuity.hpp).
//
//   WholeFace whole(face_size(model, left, right, front_slimness(object)), left);
//   if (whole.is_more_than(face_size(model, now_left, now_right, front_slimness(object)), now_left)) ...
//   whole.follow(now, now_left);        // once it is taken for the mark
//
// What is remembered is the less sure the farther the mark has gone since: no calibration is the same everywhere. A
// mark that is smaller, and taken for whole all the same, is remembered anew; one that is larger, little by little.

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/sight/stereo.hpp"

namespace pizarra {

// What the mark's standard deviations would be from the front.
struct FaceSize {
  struct Reading {
    double value;
    double spread;  // how far it may be off, as a part of it: a standard deviation
  };
  Reading area_mm2;   // the product of both principal ones
  Reading height_mm;  // along y: a turn about the vertical does not change it
  double contrast;    // grey levels, of both images
};

// `front_slimness`: of the mark from the front; what is slim gets higher or lower as it turns in the image.
FaceSize face_size(const StereoModel& model, const SeenMark& left, const SeenMark& right, double front_slimness);

class WholeFace {
 public:
  WholeFace(const FaceSize& size, const SeenMark& left);

  // Clearly, by what noise makes.
  bool is_more_than(const FaceSize& now, const SeenMark& left) const;
  void follow(const FaceSize& now, const SeenMark& left);

 private:
  FaceSize foreseen(const SeenMark& left) const;
  // How far it may be off beside the one remembered, which was seen in its own way.
  FaceSize compared(FaceSize now) const;

  FaceSize size_;
  cv::Point2d place_;
};

}  // namespace pizarra
