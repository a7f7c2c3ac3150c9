#include "programs/chaos/draw_faults.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace pizarra::chaos {

namespace {

constexpr const char* drawn_operations[] = {"PICK-UP", "PUT-DOWN", "STACK", "UNSTACK"};
constexpr const char* agents[] = {"robot", "vision", "planner", "coordinator"};
constexpr const char* with_board[] = {"robot", "vision", "planner", "coordinator", "board"};

// What draws the faults of one class.
struct Draw {
  const forms::CellDescription& cell;
  const std::vector<Datum>& goal;
  double phase_s;
  Random& random;

  // Rounded to hundredths, as lengths are too.
  double seconds(double low, double high) { return std::round(random.uniform(low, high) * 100) / 100; }
  template <std::size_t N>
  Datum one_of(const char* const (&words)[N]) {
    return Datum::symbol(words[random.below(N)]);
  }
  Datum cube() { return Datum::symbol(cell.cubes[random.below(cell.cubes.size())].name); }
  std::pair<Datum, Datum> two_cubes() {
    Datum one = cube();
    Datum other = cube();
    while (other == one) other = cube();
    return {one, other};
  }
  // After how many suspension points of a process.
  std::uint64_t steps() { return random.below(400) + 1; }
  double x() { return seconds(cell.row.x_mm - 25, cell.row.x_mm + 25); }
  double y() { return seconds(cell.row.y_low_mm, cell.row.y_high_mm); }
  // At any time of the phase, or when the servo is in some state during some operation.
  Fault::When when() {
    if (random.below(2) == 0) return {.after_s = seconds(0, phase_s)};
    return {.after_s = seconds(0, 1.5),
            .operation = drawn_operations[random.below(std::size(drawn_operations))],
            .servo_state = static_cast<int>(random.below(5))};
  }
};

Datum word(std::string_view text) { return Datum::symbol(text); }

Datum network(Draw& draw) {
  const Datum who = draw.one_of(agents);
  switch (draw.random.below(3)) {
    case 0:
      return list(word("delay"), draw.seconds(0.005, 0.06), draw.seconds(1, 6));
    case 1:
      return list(word("stall"), who, draw.seconds(0.2, 4));
    default:
      return list(word("break"), who);
  }
}

// Something of what the goal wants is done.
Datum help(Draw& draw) {
  const Datum& wanted = draw.goal[draw.random.below(draw.goal.size())];
  if (wanted.is_form("on")) return list(word("hand"), word("stack"), wanted[1], wanted[2]);
  return list(word("hand"), word("place"), draw.cube(), draw.x(), draw.y());
}

Datum hand(Draw& draw) {
  const auto [cube, other] = draw.two_cubes();
  switch (draw.random.below(9)) {
    case 0:
      return list(word("hand"), word("push"), cube, draw.seconds(-20, 20), draw.seconds(-60, 60));
    case 1:
      return list(word("hand"), word("place"), cube, draw.x(), draw.y());
    case 2:
      return list(word("hand"), word("stack"), cube, other);
    case 3:
      return list(word("hand"), word("steal"), cube);
    case 4:
      return list(word("hand"), word("remove"), cube);
    case 5:
      return list(word("borrow"), cube, draw.seconds(2, 10), draw.x(), draw.y());
    case 6:
      return list(word("hand"), word("hold"), cube, draw.x(), draw.y(), draw.seconds(150, 350), draw.seconds(1, 8));
    case 7:
      return help(draw);
    default:
      return list(word("hand"), word("knock"), cube);
  }
}

Datum disk(Draw& draw) {
  switch (draw.random.below(3)) {
    case 0:
      return list(word("full"), draw.seconds(1, 8));
    case 1:
      return list(word("fails"), draw.seconds(1, 8));
    default:
      return list(word("slow"), draw.seconds(0.02, 0.4), draw.seconds(2, 10));
  }
}

Datum frames(Draw& draw) {
  switch (draw.random.below(3)) {
    case 0:
      return list(word("dropped"), draw.seconds(0.3, 5));
    case 1:
      return list(word("frozen"), draw.seconds(0.3, 5));
    default:
      return list(word("late"), draw.seconds(0.05, 0.6), draw.seconds(1, 6));
  }
}

Datum sight(Draw& draw) {
  if (draw.random.below(2) == 0) return list(word("hidden"), draw.seconds(0, 0.8), draw.seconds(0.2, 4));
  return list(word("jumps"), draw.random.below(40) + 1, draw.seconds(0.1, 0.4));
}

Datum swap(Draw& draw) {
  const auto [one, other] = draw.two_cubes();
  return list(word("swap"), one, other, draw.seconds(0.2, 2));
}

Datum arm(Draw& draw) {
  switch (draw.random.below(3)) {
    case 0:
      return list(word("away"), draw.seconds(0.2, 4));
    case 1:
      return list(word("acks-late"), draw.seconds(0.05, 1.5), draw.seconds(1, 6));
    default:
      return list(word("stops-short"));
  }
}

// 30 mm and 3 degrees at most, in any direction. Where the cameras stand on a pan-tilt unit, that is turned as often.
Datum bump(Draw& draw) {
  constexpr double most_turn_deg = 2.1;
  if (!draw.cell.head.empty() && draw.random.below(2) == 0) {
    const double pan_deg = draw.seconds(-most_turn_deg, most_turn_deg);
    return list(word("nudge"), pan_deg, draw.seconds(-most_turn_deg, most_turn_deg));
  }
  constexpr double most_mm = 17;
  constexpr double most_deg = 1.7;
  std::vector<Datum> parts{word("bump")};
  for (int axis = 0; axis < 6; ++axis) {
    const double most = axis < 3 ? most_mm : most_deg;
    parts.push_back(to_datum(draw.seconds(-most, most)));
  }
  return Datum::list(std::move(parts));
}

Datum board(Draw& draw, Draw& own) {
  const double away_s = draw.seconds(0.3, 4);
  return list(word(draw.random.below(2) == 0 ? "kill" : "power-cut"), own.steps(), away_s);
}

// Which way it jumps, by some tenths of a second or some seconds.
Datum clock(Draw& draw) {
  const Datum who = draw.one_of(with_board);
  const double most_s = draw.random.below(2) == 0 ? 1 : 5;
  const double by_s = draw.seconds(0.1, most_s);
  return list(word("jump"), who, draw.random.below(2) == 0 ? by_s : -by_s);
}

// Some numbers come from a stream of their own, so that each seed draws the others as it would without these.
Datum what(const std::string& kind, Draw& draw, Draw& own) {
  if (kind == "network") return network(draw);
  if (kind == "reply") return list(word("lose-reply"), draw.one_of(agents));
  if (kind == "agent") {
    const Datum who = draw.one_of(agents);
    return list(word("kill"), who, draw.steps(), draw.seconds(0.3, 5));
  }
  if (kind == "pause") {
    const Datum who = draw.one_of(with_board);
    return list(word("pause"), who, own.steps(), draw.seconds(0.05, 5));
  }
  if (kind == "board") return board(draw, own);
  if (kind == "disk") return disk(draw);
  if (kind == "frames") return frames(draw);
  if (kind == "sight") return sight(draw);
  if (kind == "arm") return arm(draw);
  if (kind == "pendant") return list(word("pendant"), draw.seconds(0.5, 6));
  if (kind == "sensor") return list(word("stuck"), draw.seconds(0.5, 6));
  if (kind == "slip") return list(word("slip"));
  if (kind == "misplace") return list(word("misplace"), draw.seconds(0.1, 0.5));
  if (kind == "hand") return hand(draw);
  if (kind == "stop") return list(word(draw.random.below(3) == 0 ? "command" : "stop"), draw.seconds(0.3, 5));
  if (kind == "swap") return swap(draw);
  if (kind == "clock") return clock(draw);
  if (kind == "alarm") return list(word("alarm"), draw.seconds(0.3, 5));
  if (kind == "bump") return bump(draw);
  assert(kind == "light" && "each class has faults that are drawn");
  return list(word("light"), draw.seconds(0.5, 1.5), draw.seconds(0.5, 6));
}

// A cube that is not seen is told of beside another, in one to a few looks.
Datum invented(Draw& draw) {
  constexpr std::uint64_t most_looks = 4;
  const auto [one, other] = draw.two_cubes();
  const double aside_px = draw.seconds(30, 80);
  const bool left = draw.random.below(2) == 0;
  return list(word("invented"), one, other, left ? -aside_px : aside_px, draw.random.below(most_looks) + 1);
}

// Drawn in place of another.
Datum or_instead(const std::string& kind, Datum drawn, Draw& own) {
  constexpr std::uint64_t instead_in = 4;
  if (own.random.below(instead_in) != 0) return drawn;
  if (kind == "frames") return list(word("doubled"), own.seconds(0.3, 5));
  if (kind == "sight") return invented(own);
  if (kind == "arm") {
    const double after_s = own.seconds(0.01, 0.3);
    return list(word("acks-twice"), after_s, own.seconds(1, 6));
  }
  return drawn;
}

}  // namespace

std::vector<Fault> draw_faults(const std::string& kind, const forms::CellDescription& cell,
                               const std::vector<Datum>& goal, double phase_s, Random random) {
  std::vector<Fault> faults;
  Random instead = random.split("instead");
  Draw own{cell, goal, phase_s, instead};
  Draw draw{cell, goal, phase_s, random};
  // More than one bump might take the gripper's mark out of the view.
  const std::uint64_t most = kind == "hand" ? 5 : kind == "bump" ? 1 : 3;
  for (std::uint64_t left = random.below(most) + 1; left > 0; --left) {
    Fault::When when = draw.when();
    Datum drawn = or_instead(kind, what(kind, draw, own), own);
    faults.push_back({kind, std::move(when), std::move(drawn)});
  }
  return faults;
}

}  // namespace pizarra::chaos
