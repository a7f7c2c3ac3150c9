#pragma once

// In which size a page is sent its pictures: full ones where its line carries them with ease, light ones otherwise.
//
//   PictureSize size;                                       // it begins with light ones
//   size.note({.sent = sent, .bytes = 4700, .full_bytes = 12'000, .waited = 19ms});     // one was drawn
//   if (size.is_light()) ...
//
// The quickest of the last pictures tells how long the line takes for a byte. The others waited for something else as
// well, such as a lost packet, a busy page, or each other. How many come in a second is known from all of them. So
// it is known how much of the line full ones would need, whatever the scene shows. Where full ones turn out to be too
// much they are tried again later and later.

#include <cstddef>
#include <deque>

#include "blackboard/time/clock.hpp"

namespace pizarra::console {

class PictureSize {
 public:
  struct Drawn {
    Time sent{};
    std::size_t bytes = 0;
    std::size_t full_bytes = 0;  // of the full picture of that frame
    Duration waited{};           // how much longer than the line's round trip it was under way
  };

  void note(const Drawn& drawn);
  bool is_light() const { return light_; }

 private:
  static constexpr Duration too_long = 150ms;
  static constexpr Duration first_pause = 10s;

  // How much of the line full pictures need; 1: all of it.
  double full_share() const;
  void become_light(Time now);

  std::deque<Drawn> recent_;  // the newest last
  Duration wait_ = too_long;  // smoothed; it starts high
  bool light_ = true;
  Time not_full_before_{};
  Duration pause_ = first_pause;
};

}  // namespace pizarra::console
