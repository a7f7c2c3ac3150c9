#include "agents/coordinator/act/rescues.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pizarra::coordinator {

namespace {

// That are taken out of the way of a sweep, such as a pile beside the object.
constexpr int most_neighbours = 3;
// In a row, of an object that is taken away.
constexpr int most_slips = 5;

}  // namespace

bool Rescues::is_held(double closed_mm) const { return domain_.edge_like(closed_mm).has_value(); }

// The object is not known, so its mark does not say how it is held: the gripper alone is aimed.
Task<Result<void>> Rescues::lay_down(std::string object) {
  return lay_down_at(list("free-spot"_sym, "held"_sym), std::move(object));
}

Task<Result<void>> Rescues::lay_down_at(Datum spot, std::string object) {
  if (!seems_to_hold()) co_return Result<void>();
  const Result<double> closed = co_await arm_.grip(0);
  if (!closed) co_return fail(closed);
  if (!is_held(*closed)) co_return Result<void>();
  co_await story_.tell("servo", "laying down what the gripper holds", Datum::symbol(object));
  // It may be held askew and touch the table early: it is let go wherever the way down ended.
  const std::vector<Datum> down{list("raise"_sym), list("square-up"_sym), list("align"_sym, spot),
                                list("lower"_sym, spot)};
  const Result<void> lowered = co_await runner_.improvise(down);
  const bool was_met = !lowered && lowered.error().symbol == "stopped" && !met_silence(lowered.error());
  const bool interrupted = !lowered && !was_met;
  if (interrupted) co_return lowered;
  const std::vector<Datum> let_go{list("release"_sym), list("raise"_sym)};
  const Result<void> released = co_await runner_.improvise(let_go);
  co_return released;
}

Task<Result<void>> Rescues::set_aside(std::string object) {
  const std::string sentence = fmt::format("setting {} aside, to see what it hides", object);
  co_await story_.tell("servo", sentence, Datum::symbol(object));
  co_return co_await take_away(std::move(object));
}

// An object that slips is grasped again, unless it has come to lie elsewhere.
Task<Result<void>> Rescues::take_away(std::string object) {
  const Sighting* seen = scene_.sightings().find(object);
  if (!seen) co_return fail("lost-sight", fmt::format("{} is not seen", object), Datum::symbol(object));
  const Eigen::Vector3d stood = scene_.centre_mm(object, *seen);
  // A missing object may be anywhere behind where it stood, and is not to be hidden again.
  const Datum spot = list("free-spot"_sym, "held"_sym, stood.x(), stood.y());
  for (int slips = 0; slips < most_slips; ++slips) {
    Result<void> taken = co_await grasp(object);
    if (taken) taken = co_await lay_down_at(spot, object);
    const bool has_slipped = !taken && taken.error().symbol == "slipped";
    if (has_slipped) taken = co_await let_it_lie(object);
    if (!taken) co_return taken;
    if (is_away_from(object, stood)) co_return Result<void>();
    if (!has_slipped) break;
  }
  co_return fail("missed", fmt::format("{} lies where it lay", object), Datum::symbol(object));
}

Task<Result<void>> Rescues::grasp(std::string object) {
  const Datum name = Datum::symbol(object);
  const std::vector<Datum> steps{list("open"_sym, name),  list("raise"_sym),       list("turn-fingers"_sym, name),
                                 list("align"_sym, name), list("lower"_sym, name), list("close"_sym),
                                 list("raise"_sym)};
  co_return co_await runner_.improvise(steps);
}

Task<Result<void>> Rescues::let_it_lie(std::string object) {
  const std::vector<Datum> steps{list("open"_sym, Datum::symbol(object)), list("raise"_sym)};
  co_return co_await runner_.improvise(steps);
}

bool Rescues::is_away_from(const std::string& object, const Eigen::Vector3d& place_mm) const {
  const Sighting* lies = scene_.sightings().find(object);
  return lies && (scene_.centre_mm(object, *lies) - place_mm).head<2>().norm() >= domain_.cube_mm() / 2;
}

Task<Result<void>> Rescues::bring_into_view(std::string object) {
  const std::string sentence = fmt::format("the images cut {} off: bringing it to where all of it shows", object);
  co_await story_.tell("servo", sentence, Datum::symbol(object));
  const Result<void> laid = co_await lay_down(object);
  if (!laid) co_return laid;
  const Result<void> cleared = co_await clear_way_inwards(object);
  if (!cleared) co_return cleared;
  const std::optional<Push> inwards = pushes_.sweep_inwards(object);
  if (!inwards) co_return co_await take_away(std::move(object));
  const Result<void> swept = co_await pushes_.sweep(*inwards);
  if (!swept) co_return swept;
  const std::vector<Datum> up{list("raise"_sym)};
  co_return co_await runner_.improvise(up);
}

Task<Result<void>> Rescues::clear_way_inwards(std::string object) {
  for (int moved = 0; moved < most_neighbours; ++moved) {
    if (pushes_.sweep_inwards(object)) break;
    const std::optional<std::string> neighbour = scene_.neighbour_of(object);
    if (!neighbour) break;
    const Result<void> away = co_await take_away(*neighbour);
    if (!away) co_return away;
  }
  co_return Result<void>();
}

std::optional<Push> Rescues::next_sweep(const std::string& missing, bool was_here,
                                        const std::vector<Push>& swept) const {
  const auto is_done = [&](const Push& sweep) {
    return std::ranges::any_of(swept, [&](const Push& done) {
      return done.lifts == sweep.lifts && (done.from_mm - sweep.from_mm).norm() < domain_.cube_mm() / 2;
    });
  };
  for (const Push& sweep : pushes_.sweeps_for(missing, was_here)) {
    if (!is_done(sweep)) return sweep;
  }
  return std::nullopt;
}

Task<Result<void>> Rescues::sweep_in(std::string missing, Push sweep) {
  const std::string sentence =
      fmt::format("sweeping at the border of the images, where {} may lie or be hidden", missing);
  co_await story_.tell("servo", sentence, Datum::symbol(missing));
  const std::vector<Datum> up{list("raise"_sym)};
  Result<void> done = co_await runner_.improvise(up);
  if (done) done = co_await pushes_.sweep(sweep);
  if (done) done = co_await runner_.improvise(up);
  if (done) done = co_await lay_down(missing);
  co_return done;
}

// Fingers that press on a neighbour cannot close, and are as wide open as they were. Nothing is between them higher up.
Task<Result<bool>> Rescues::fingers_stay_at(double opened_mm) {
  const std::vector<Datum> up{list("raise"_sym)};
  const Result<void> raised = co_await runner_.improvise(up);
  if (!raised) co_return fail(raised);
  const Result<double> closed = co_await arm_.grip(0);
  if (!closed) co_return fail(closed);
  co_return std::abs(opened_mm - *closed) < 1;
}

Task<Result<void>> Rescues::loosen(Datum operation) {
  if (operation.size() < 2) co_return Result<void>();
  const std::string object(operation[1].text());
  const Result<double> closed = co_await arm_.grip(0);
  if (!closed) co_return fail(closed);
  if (is_held(*closed)) {
    const Result<void> laid = co_await lay_down(object);
    const bool onto_nothing = operation.size() < 3;
    if (!laid || onto_nothing) co_return laid;
    const std::vector<Datum> room{list("raise"_sym), list("make-room"_sym, operation[2])};
    const Result<void> made = co_await runner_.improvise(room);
    co_return made;
  }
  const bool jammed = *closed > domain_.cube_mm();
  if (jammed) {
    // Fingers that jam across a cube's edges let it go first. Others stay closed: beside them there may be no room.
    const Result<double> opened = co_await arm_.grip(widest_mm_);
    if (!opened) co_return fail(opened);
    const Result<bool> stuck = co_await fingers_stay_at(*opened);
    if (!stuck) co_return fail(stuck);
    if (*stuck) {
      const std::string sentence = fmt::format("the gripper says {:.0f} mm, closed or open", *opened);
      co_await story_.tell("servo", sentence, operation[1]);
      co_return fail("stuck", sentence);
    }
  }
  const std::string sentence = fmt::format("{} cannot be grasped as it lies: pushing it", object);
  co_await story_.tell("servo", sentence, operation[1]);
  const std::vector<Datum> push{list("raise"_sym), list("push-over"_sym, operation[1]), list("raise"_sym)};
  const Result<void> pushed = co_await runner_.improvise(push);
  co_return pushed;
}

}  // namespace pizarra::coordinator
