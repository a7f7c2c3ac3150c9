#pragma once

// What a mark that is followed in one image looked like while it was whole. Half a square is as good a square as one
// whose face is turned, so that what slides over a mark, or joins it, is no matter of shape. It is one of motion:
// turning and going away shrink a mark about its centre; covering takes one side away and leaves the opposite one where
// it was, so that the centre moves as far as the loss says.
//
//   WholeMark whole(first);
//   switch (whole.look_at(now, 1)) ...
//   whole.follow(now);                  // once it is taken for the mark
//   whole.wait();                       // a frame without it
//
// Slow covering shows over many frames only, so the memory is moved by what is seen little by little, and not at all
// while covering explains the look better.

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra {

class WholeMark {
 public:
  enum class Look : std::uint8_t {
    whole,    // as large as remembered, wherever it is; or nothing is remembered any more
    turned,   // of another size, about where it was foreseen
    covered,  // a part of it, or it and something else
    unlike,   // of another size, elsewhere
  };

  explicit WholeMark(const SeenMark& mark);

  // `most_off_px`: how far off a centre may be that is told.
  Look look_at(const SeenMark& now, double most_off_px) const;
  void follow(const SeenMark& now);
  void wait();
  bool moves() const;

 private:
  // Along one axis, px: x, y, and both diagonals, for a hand comes from anywhere.
  struct Axis {
    double place;  // of the centre
    double spread;
    double low;  // from the centre to either end
    double high;
    double speed = 0;  // a frame

    bool moves() const;
    double foreseen(int frames) const { return place + (moves() ? frames * speed : 0); }
  };
  // What the change of size and the motion of the centre say of each other on one axis, px.
  struct Evidence {
    double off = 0;     // how far the centre is off, at most, if the change of size is covering
    double moved = 0;   // what the centre moved unforeseen if it is not
    double missed = 0;  // and if it is
  };
  Evidence evidence(const Axis& axis, const Axis& now) const;
  // How many times better covering along the first explains both than turning does.
  double covering(const Evidence& covered, const Evidence& other) const;
  void follow(Axis& axis, const Axis& now, const Evidence& seen, double covering) const;

  // It was not seen for so long that it may have been put down anew.
  bool forgotten() const;

  using Axes = std::array<Axis, 4>;
  static Axes axes_of(const SeenMark& mark);
  std::array<Evidence, 4> evidence(const Axes& now) const;
  // Of a mark that is of the same form still.
  Evidence evidence_of_a_side(const Axes& now) const;

  Axes axes_;
  double unrest_ = 0;  // how far it was lately from where it was foreseen
  int frames_ = 1;     // since it was followed
  bool hidden_ = false;
};

}  // namespace pizarra
