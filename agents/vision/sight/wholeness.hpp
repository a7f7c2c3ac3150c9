#pragma once

// Remembers how a tracked mark looked while nothing covered it, in either image and to the pair. Compared with that, a
// look is certainly covered in part, or its centre may be off by so much where that cannot be known.
//
//   Wholeness whole;
//   const Wholeness::Look look = whole.look_at(model, object, pair, captured, 1, false);
//   if (look.whole) ... confidence_if_off(confidence, look.may_be_off_px, 1) ...
//   whole.follow(pair, look, captured);        // once it is taken for the mark
//   whole.wait(captured);                      // a frame without it
//   whole.lose();                              // so many that where it moved nobody knows

#include "agents/vision/sight/stereo_sight.hpp"
#include "agents/vision/sight/whole_face.hpp"
#include "agents/vision/sight/whole_mark.hpp"

namespace pizarra::vision {

class Wholeness {
 public:
  struct Look {
    bool whole = true;
    bool elsewhere = false;             // of another size, far from where it was foreseen
    bool smaller = false;               // than the pair saw it
    bool hardly_covered = false;        // so little that the centre is hardly off
    bool anew = false;                  // what was remembered was covered
    double may_be_off_px = 0;           // before a pair
    std::optional<FaceSize> face = {};  // where both images show it
  };
  // `lost`: it may be anywhere.
  Look look_at(const camera::StereoModel& model, const LearnedObject& object, const SeenPair& now, Time captured,
               double most_off_px, bool lost) const;
  void follow(const SeenPair& now, const Look& look, Time captured);
  void wait(Time captured);
  // What rested is behind what hides it.
  void lose();

 private:
  std::optional<WholeMark> left_;
  std::optional<WholeMark> right_;
  std::optional<WholeFace> face_;
};

// With this confidence and more a mark is told surely: it is the object, and its centre is within a pixel.
inline constexpr double surely = 0.9;

// How far off a centre may be, by what covers a part of the mark, that is told.
double most_off_px(const StereoSight& sight);

// The confidence once the registered outline has said how far off the centre may be. `by_look` is the confidence
// without it. The outline may make a mark surer, but not a slim one: a tilt explains most covers of that.
double confidence_by_outline(double by_look, double of_whole, const SeenPair& pair, double most_off_px);

// The greater one of both images (mark_ground.hpp); none of a tag.
double ground_doubt(const StereoSight& sight, const SeenPair& pair);

// How sure one can be of a mark by this look alone, and by what was learned of it; and by the ground around it too.
double confidence_by_form(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair);
double confidence_in_look(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair);

}  // namespace pizarra::vision
