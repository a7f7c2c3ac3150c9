#pragma once

// Remembers how a mark that is followed in one image looked while it was whole, and tells a turned one from a covered
// one. Shape does not tell them apart: half a square is as good a square as one whose face is turned. Motion does.
// Turning and going away shrink a mark about its centre. Covering takes one side away and leaves the opposite one where
// it was, so that the centre moves as far as the loss says.
//
//   WholeMark whole(first, captured);
//   switch (whole.look_at(now, captured, 1)) ...
//   whole.follow(now, captured);        // once it is taken for the mark
//   whole.wait(captured);               // a frame without it
//
// Slow covering shows over many frames only, so the memory is moved by what is seen little by little, and not at all
// while covering explains the look better. It lasts as long as the covering does: a hand may rest. A mark that was put
// down anew may look covered there. That ends when it is seen whole or elsewhere.

#include "agents/vision/marks/mark_measure.hpp"
#include "blackboard/time/clock.hpp"

namespace pizarra::vision {

class WholeMark {
 public:
  enum class Look : std::uint8_t {
    whole,    // as large as remembered, wherever it is
    turned,   // of another size, about where it was foreseen
    covered,  // a part of it, or it and something else
    unlike,   // of another size, elsewhere
  };

  WholeMark(const SeenMark& mark, Time captured);

  // `most_off_px`: how far off a centre may be that is told. `smaller`: a pair sees that less of it is to be seen, so
  // that it is covered unless its motion speaks against that.
  Look look_at(const SeenMark& now, Time captured, double most_off_px, bool smaller = false) const;
  // By its area, and by more than noise makes.
  bool is_less_than(const SeenMark& now) const;
  void follow(const SeenMark& now, Time captured);
  void wait(Time captured);
  bool moves() const;

 private:
  // Along one axis, px: x, y, and both diagonals, for a hand comes from anywhere.
  struct Axis {
    double place;  // of the centre
    double spread;
    double low;  // from the centre to either end
    double high;
    double speed = 0;  // a second

    bool moves() const;
    double foreseen(double seconds) const { return place + (moves() ? seconds * speed : 0); }
  };
  // How the change of size and the motion of the centre explain each other on one axis, px.
  struct Evidence {
    double off = 0;     // how far the centre is off, at most, if the change of size is covering
    double moved = 0;   // what the centre moved unforeseen if it is not
    double missed = 0;  // and if it is
  };
  // `seconds`: since it was followed.
  static Evidence evidence(const Axis& axis, const Axis& now, double seconds);
  // How many times better covering along the first explains both than turning does.
  double covering(const Evidence& covered, const Evidence& other) const;
  // After `seconds`, the last `frame` of them since it was looked at.
  static void follow(Axis& axis, const Axis& now, const Evidence& seen, double covering, double seconds, double frame);

  using Axes = std::array<Axis, 4>;
  static Axes axes_of(const SeenMark& mark);
  std::array<Evidence, 4> evidence(const Axes& now, double seconds) const;
  bool speaks_against_covering(const std::array<Evidence, 4>& seen) const;
  // Farther from where it was foreseen than half its size.
  bool is_elsewhere(const std::array<Evidence, 4>& seen) const;
  // The largest and the least ratio of its sizes now and then.
  struct Scales {
    double least;
    double most;
    // Nearer or farther away, or a triangle that is covered along one side.
    bool similar() const;
    // Nearer or farther away, clearly.
    bool resized() const;
  };
  Scales scales(const Axes& now) const;
  static bool may_be_a_side_less(const SeenMark& mark, const Scales& scale);
  // Of a mark that is of the same form still.
  Evidence evidence_of_a_side(const Axes& now, double seconds) const;

  Axes axes_;
  double unrest_ = 0;  // how far it was lately from where it was foreseen
  Time followed_;
  Time looked_at_;
  bool hidden_ = false;
};

}  // namespace pizarra::vision
