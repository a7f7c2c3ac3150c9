#include "agents/vision/sight/continuity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pizarra {
namespace {

// Of a centre at rest, by noise and the pixels' phase; and what is none of that.
constexpr double rest_px = 0.25;
constexpr double clear_px = 3 * rest_px;
// Slower than that a frame, what looks like motion may be covering.
constexpr double least_speed_px = 0.5;
constexpr double speed_gain = 0.3;
constexpr double place_gain = 0.15;
constexpr double spread_gain = 0.1;
constexpr double unrest_kept = 0.8;
// How many times better one explanation must be than the other: where it is told, and where it is remembered.
constexpr double sure = 2.7;
constexpr double suspicious = 1.35;
// Less change of size than noise makes, in px of the centre.
constexpr double least_off_px = 0.2;
// Frames.
constexpr int most_remembered = 100;
// The largest ratio of the changes of size on all axes, of a mark that is nearer or farther away.
constexpr double similar_scales = 1.03;
// From the centre of a triangle to its corners, in standard deviations.
const double corner_reach = std::sqrt(8.0);
// Of the motion that covering makes, how much is left unexplained where much is covered: by how the shape is.
constexpr double most_missed = 0.5;

// How far the centre moves for every px that the standard deviation shrinks, where a little is taken away `reach` from
// it: a part p of the mark there moves the mean by p reach, and the variance by p (spread^2 - reach^2).
double motion_of_covering(double reach, double spread) {
  const double far = std::max(reach, 1.2 * spread);
  return 2 * far * spread / (far * far - spread * spread);
}

// The axis at a right angle.
std::size_t across(std::size_t axis) { return axis ^ 1; }

}  // namespace

bool WholeMark::Axis::moves() const { return std::abs(speed) >= least_speed_px; }

WholeMark::Axes WholeMark::axes_of(const SeenMark& mark) {
  const auto [x, y] = mark.centre;
  const double mean = (mark.width_px * mark.width_px + mark.height_px * mark.height_px) / 2;
  const auto diagonal = [](double place, double variance) {
    // A disc ends there.
    const double spread = std::sqrt(std::max(variance, 0.0));
    return Axis{.place = place, .spread = spread, .low = 2 * spread, .high = 2 * spread};
  };
  return {Axis{.place = x, .spread = mark.width_px, .low = x - (mark.box.x - 0.5), .high = mark.box.br().x - 0.5 - x},
          Axis{.place = y, .spread = mark.height_px, .low = y - (mark.box.y - 0.5), .high = mark.box.br().y - 0.5 - y},
          diagonal((x + y) / std::numbers::sqrt2, mean + mark.slant_px2),
          diagonal((x - y) / std::numbers::sqrt2, mean - mark.slant_px2)};
}

WholeMark::WholeMark(const SeenMark& mark) : axes_(axes_of(mark)) {}

bool WholeMark::moves() const {
  return std::ranges::any_of(axes_, [](const Axis& axis) { return axis.moves(); });
}

void WholeMark::wait() {
  ++frames_;
  hidden_ = true;
}

bool WholeMark::forgotten() const { return hidden_ && frames_ > most_remembered; }

// It is foreseen where it was, or going on as it went: a hand may stop it.
WholeMark::Evidence WholeMark::evidence(const Axis& axis, const Axis& now) const {
  const double change = axis.spread - now.spread;
  const double by_low = motion_of_covering(axis.low, axis.spread) * change;
  const double by_high = -motion_of_covering(axis.high, axis.spread) * change;
  constexpr double endless = std::numeric_limits<double>::infinity();
  Evidence out{.off = std::max(std::abs(by_low), std::abs(by_high)), .moved = endless, .missed = endless};
  for (const double foreseen : {axis.place, axis.foreseen(frames_)}) {
    const double motion = now.place - foreseen;
    out.moved = std::min(out.moved, std::abs(motion));
    out.missed = std::min({out.missed, std::abs(motion - by_low), std::abs(motion - by_high)});
  }
  return out;
}

// Unforeseen motions have heavy tails, Cauchy's: a push is none of the ordinary ones.
double WholeMark::covering(const Evidence& covered, const Evidence& other) const {
  const auto squared = [](double a, double b) { return a * a + b * b; };
  const double usual = squared(rest_px, unrest_);
  const double if_turned = usual + squared(covered.moved, other.moved);
  const double if_covered = usual + squared(covered.missed, std::min(other.moved, other.missed));
  return if_turned / if_covered;
}

// What covers a triangle along one side leaves a triangle of the same form with the corner opposite.
WholeMark::Evidence WholeMark::evidence_of_a_side(const Axes& now) const {
  const double spread = (axes_[0].spread + axes_[1].spread) / 2;
  const double change = spread - (now[0].spread + now[1].spread) / 2;
  constexpr double endless = std::numeric_limits<double>::infinity();
  Evidence out{.off = corner_reach * change, .moved = endless, .missed = endless};
  for (const int frames : {0, frames_}) {
    const double motion =
        std::hypot(now[0].place - axes_[0].foreseen(frames), now[1].place - axes_[1].foreseen(frames));
    out.moved = std::min(out.moved, motion);
    out.missed = std::min(out.missed, std::abs(motion - out.off));
  }
  return out;
}

std::array<WholeMark::Evidence, 4> WholeMark::evidence(const Axes& now) const {
  std::array<Evidence, 4> out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = evidence(axes_[i], now[i]);
  return out;
}

WholeMark::Look WholeMark::look_at(const SeenMark& mark, double most_off_px) const {
  const Axes now = axes_of(mark);
  const std::array<Evidence, 4> seen = evidence(now);
  const double off = std::max(std::hypot(seen[0].off, seen[1].off), std::hypot(seen[2].off, seen[3].off));
  if (off <= most_off_px || forgotten()) return Look::whole;
  const auto beyond = [&](std::size_t i) { return seen[i].moved > std::max(axes_[i].low, axes_[i].high); };
  // Who moves so far may well turn by 30 degrees.
  if (beyond(0) || beyond(1)) return off <= 2 * most_off_px ? Look::whole : Look::unlike;
  std::array<double, 4> scales;
  for (std::size_t i = 0; i < scales.size(); ++i) scales[i] = now[i].spread / axes_[i].spread;
  const auto [least, most] = std::ranges::minmax(scales);
  // Nearer or farther away, or a triangle that is covered along one side.
  const bool similar = most < similar_scales * least;
  if (similar && least > 1) return Look::turned;
  if (similar) {
    const Evidence side = evidence_of_a_side(now);
    return side.missed < clear_px && covering(side, {}) > sure ? Look::covered : Look::turned;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Evidence& one = seen[i];
    const Evidence& other = seen[across(i)];
    if (one.off < most_off_px / 2) continue;
    const double by_covering = covering(one, other);
    if (by_covering > sure) return Look::covered;
    // What comes back from behind something is a part at first.
    const bool explained =
        std::hypot(one.missed, std::min(other.moved, other.missed)) < clear_px + most_missed * one.off;
    if (hidden_ && by_covering > 1 / sure && explained) return Look::covered;
  }
  return Look::turned;
}

void WholeMark::follow(Axis& axis, const Axis& now, const Evidence& seen, double covering) const {
  const double foreseen = axis.foreseen(frames_);
  const double gain = seen.missed > clear_px ? 1 : place_gain;
  axis.speed += speed_gain * ((now.place - axis.place) / frames_ - axis.speed);
  axis.place = foreseen + gain * (now.place - foreseen);
  axis.spread += (covering < 1 / suspicious ? 1 : spread_gain) * (now.spread - axis.spread);
  axis.low = now.low;
  axis.high = now.high;
}

void WholeMark::follow(const SeenMark& mark) {
  if (forgotten()) {
    *this = WholeMark(mark);
    return;
  }
  const Axes now = axes_of(mark);
  const std::array<Evidence, 4> seen = evidence(now);
  std::array<double, 4> by_covering;
  bool held = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    by_covering[i] = covering(seen[i], seen[across(i)]);
    held = held || (seen[i].off > least_off_px && seen[i].missed < clear_px && by_covering[i] > suspicious);
  }
  hidden_ = false;
  if (held) {
    ++frames_;
    return;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) follow(axes_[i], now[i], seen[i], by_covering[i]);
  unrest_ = std::max(unrest_kept * unrest_, std::hypot(seen[0].moved, seen[1].moved));
  frames_ = 1;
}

}  // namespace pizarra
