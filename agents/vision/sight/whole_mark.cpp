#include "agents/vision/sight/whole_mark.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "agents/vision/marks/mark_outline.hpp"
#include "agents/vision/sight/covered_part.hpp"
#include "agents/vision/sight/frame_time.hpp"

namespace pizarra::vision {
namespace {

// Of a centre at rest, by noise and the pixels' phase; and what is none of that.
constexpr double rest_px = 0.25;
constexpr double clear_px = 3 * rest_px;
// Slower than that a second, what looks like motion may be covering.
constexpr double least_speed_px = 5;
// How much of what is new the memory takes over a second, at that rate.
constexpr double speed_rate = 3;
constexpr double place_rate = 1.5;
constexpr double spread_rate = 1;
constexpr double unrest_rate = 2;
// How many times better one explanation must be than the other: where it is told, and where it is remembered.
constexpr double sure = 2.7;
constexpr double suspicious = 1.35;
// Less change of size than noise makes, in px of the centre.
constexpr double least_off_px = 0.2;
// The largest ratio of the changes of size on all axes, of a mark that is nearer or farther away.
constexpr double similar_scales = 1.03;
// The least ratio of its areas where more of a mark is to be seen than was.
constexpr double least_growth = 1.02;
// Of the motion that covering makes, how much is left unexplained where much is covered: by how the shape is.
constexpr double most_missed = 0.5;

// How far the centre moves for every px that the standard deviation shrinks, where a little is taken away `reach` from
// it: a part p of the mark there moves the mean by p reach, and the variance by p (spread^2 - reach^2).
double motion_of_covering(double reach, double spread) {
  const double far = std::max(reach, 1.2 * spread);
  return 2 * far * spread / (far * far - spread * spread);
}

double norm_of(double x, double y) { return std::sqrt(x * x + y * y); }

// The axis at a right angle.
std::size_t across(std::size_t axis) { return axis ^ 1; }

// The share of the new that is taken over in so many seconds.
double gain(double rate, double seconds) { return std::min(1.0, rate * seconds); }

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

WholeMark::WholeMark(const SeenMark& mark, Time captured)
    : axes_(axes_of(mark)), followed_(captured), looked_at_(captured) {}

bool WholeMark::moves() const {
  return std::ranges::any_of(axes_, [](const Axis& axis) { return axis.moves(); });
}

void WholeMark::wait(Time captured) {
  looked_at_ = captured;
  hidden_ = true;
}

// It is foreseen where it was, or going on as it went: a hand may stop it.
WholeMark::Evidence WholeMark::evidence(const Axis& axis, const Axis& now, double seconds) {
  const double change = axis.spread - now.spread;
  const double by_low = motion_of_covering(axis.low, axis.spread) * change;
  const double by_high = -motion_of_covering(axis.high, axis.spread) * change;
  constexpr double endless = std::numeric_limits<double>::infinity();
  Evidence out{.off = std::max(std::abs(by_low), std::abs(by_high)), .moved = endless, .missed = endless};
  for (const double foreseen : {axis.place, axis.foreseen(seconds)}) {
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

// A cover along one side of a triangle leaves a triangle of the same form, with the corner opposite.
WholeMark::Evidence WholeMark::evidence_of_a_side(const Axes& now, double seconds) const {
  const double spread = (axes_[0].spread + axes_[1].spread) / 2;
  const double change = spread - (now[0].spread + now[1].spread) / 2;
  constexpr double endless = std::numeric_limits<double>::infinity();
  Evidence out{.off = triangle_reach * change, .moved = endless, .missed = endless};
  for (const double after : {0.0, seconds}) {
    const double motion = norm_of(now[0].place - axes_[0].foreseen(after), now[1].place - axes_[1].foreseen(after));
    out.moved = std::min(out.moved, motion);
    out.missed = std::min(out.missed, std::abs(motion - out.off));
  }
  return out;
}

std::array<WholeMark::Evidence, 4> WholeMark::evidence(const Axes& now, double seconds) const {
  std::array<Evidence, 4> out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = evidence(axes_[i], now[i], seconds);
  return out;
}

bool WholeMark::is_elsewhere(const std::array<Evidence, 4>& seen) const {
  const auto beyond = [&](std::size_t i) { return seen[i].moved > std::max(axes_[i].low, axes_[i].high); };
  return beyond(0) || beyond(1);
}

WholeMark::Scales WholeMark::scales(const Axes& now) const {
  std::array<double, 4> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = now[i].spread / axes_[i].spread;
  const auto [least, most] = std::ranges::minmax(all);
  return {least, most};
}

bool WholeMark::Scales::similar() const { return most < similar_scales * least; }

bool WholeMark::Scales::resized() const {
  const double change = std::max(least - 1, 1 - most);
  return change > most - least && change > similar_scales - 1;
}

// Of those that are smaller and of the same form.
bool WholeMark::may_be_a_side_less(const SeenMark& mark, const Scales& scale) {
  return scale.least < 1 && is_triangle(outline_of(mark.signature));
}

// On no axis along which it lost much is its motion that of what is covered.
bool WholeMark::speaks_against_covering(const std::array<Evidence, 4>& seen) const {
  const double most = std::ranges::max(seen, {}, &Evidence::off).off;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].off >= most / 2 && covering(seen[i], seen[across(i)]) > 1 / sure) return false;
  }
  return true;
}

WholeMark::Look WholeMark::look_at(const SeenMark& mark, Time captured, double most_off_px, bool smaller) const {
  const Axes now = axes_of(mark);
  const double seconds = seconds_between(followed_, captured);
  const std::array<Evidence, 4> seen = evidence(now, seconds);
  const double off = std::max(norm_of(seen[0].off, seen[1].off), norm_of(seen[2].off, seen[3].off));
  if (off <= most_off_px && !smaller) return Look::whole;
  // A mark that moves so far may well turn by 30 degrees.
  if (is_elsewhere(seen)) return off <= 2 * most_off_px ? Look::whole : Look::unlike;
  if (smaller) return speaks_against_covering(seen) ? Look::turned : Look::covered;
  const Scales scale = scales(now);
  if (scale.similar() && !may_be_a_side_less(mark, scale)) return Look::turned;
  if (scale.similar()) {
    const Evidence side = evidence_of_a_side(now, seconds);
    return side.missed < clear_px && covering(side, {}) > sure ? Look::covered : Look::turned;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Evidence& one = seen[i];
    const Evidence& other = seen[across(i)];
    if (one.off < most_off_px / 2) continue;
    const double by_covering = covering(one, other);
    if (by_covering > sure) return Look::covered;
    // A mark that comes back from behind something shows only a part at first.
    const bool explained = norm_of(one.missed, std::min(other.moved, other.missed)) < clear_px + most_missed * one.off;
    if (hidden_ && by_covering > 1 / sure && explained) return Look::covered;
  }
  return Look::turned;
}

bool WholeMark::is_less_than(const SeenMark& now) const {
  const double area = axes_[0].spread * axes_[1].spread;
  return now.width_px * now.height_px > least_growth * area;
}

void WholeMark::follow(Axis& axis, const Axis& now, const Evidence& seen, double covering, double seconds,
                       double frame) {
  const double foreseen = axis.foreseen(seconds);
  const double place_gain = seen.missed > clear_px ? 1 : gain(place_rate, frame);
  axis.speed += gain(speed_rate, frame) * ((now.place - axis.place) / seconds - axis.speed);
  axis.place = foreseen + place_gain * (now.place - foreseen);
  axis.spread += (covering < 1 / suspicious ? 1 : gain(spread_rate, frame)) * (now.spread - axis.spread);
  axis.low = now.low;
  axis.high = now.high;
}

void WholeMark::follow(const SeenMark& mark, Time captured) {
  const Axes now = axes_of(mark);
  const double seconds = seconds_between(followed_, captured);
  const double frame = seconds_between(looked_at_, captured);
  const std::array<Evidence, 4> seen = evidence(now, seconds);
  // Put down elsewhere, nearer or farther away, while it was hidden: what it was like before says nothing.
  const Scales scale = scales(now);
  const bool resized = scale.resized() && !may_be_a_side_less(mark, scale);
  if (hidden_ && (is_elsewhere(seen) || resized)) {
    *this = WholeMark(mark, captured);
    return;
  }
  std::array<double, 4> by_covering;
  bool held = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    by_covering[i] = covering(seen[i], seen[across(i)]);
    held = held || (seen[i].off > least_off_px && seen[i].missed < clear_px && by_covering[i] > suspicious);
  }
  const bool was_hidden = std::exchange(hidden_, false);
  looked_at_ = captured;
  if (held) return;
  for (std::size_t i = 0; i < seen.size(); ++i) follow(axes_[i], now[i], seen[i], by_covering[i], seconds, frame);
  // How far it moved while it was hidden says nothing of how restless it is.
  const double moved = was_hidden ? 0 : norm_of(seen[0].moved, seen[1].moved);
  unrest_ = std::max((1 - gain(unrest_rate, frame)) * unrest_, moved);
  followed_ = captured;
}

}  // namespace pizarra::vision
