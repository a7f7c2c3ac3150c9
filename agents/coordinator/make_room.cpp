#include <fmt/format.h>

#include "agents/coordinator/task_runner.hpp"

namespace pizarra {

namespace {

// The highest pile that can be pushed, in cube sizes: what stands higher would topple, and meet the gripper's palm.
constexpr double highest_pile = 2;
// The palm passes over a pile of two, and the fingers still reach the lower one.
constexpr double grip_height = 0.7;
constexpr double careful_percent = 30;
constexpr double usual_percent = 100;

std::string move_to(double x_mm, double y_mm, double z_mm) {
  return fmt::format("(move {:.2f} {:.2f} {:.2f})", x_mm, y_mm, z_mm);
}

}  // namespace

std::optional<Push> TaskRunner::push_for(std::string_view object) const {
  const Sightings& sightings = surroundings_.sightings();
  const Sighting* target = sightings.find(object);
  if (!target || target->place_mm.z() > highest_pile * domain_.cube_mm()) return std::nullopt;
  std::vector<Eigen::Vector3d> others;
  for (const auto& [name, sighting] : sightings.all()) {
    if (name != object && name != options_.gripper.mark) others.push_back(surroundings_.centre_mm(name, sighting));
  }
  ElbowRoom room;
  room.cube_mm = domain_.cube_mm();
  room.finger_mm = options_.gripper.finger_mm;
  room.narrow_mm = options_.gripper.narrow_mm;
  return push_for_room(room, surroundings_.centre_mm(std::string(object), *target), others);
}

Task<Result<void>> TaskRunner::make_room(std::string object) {
  const std::optional<Push> push = push_for(object);
  if (!push) co_return Result<void>();
  const std::string sentence = fmt::format("{} stands too close to its neighbour: pushing it out of the row", object);
  co_await story_.tell("servo", sentence, Datum::symbol(object));
  const double pusher_mm = ElbowRoom().pusher_mm;
  const Result<void> narrowed = co_await open(pusher_mm);
  if (!narrowed) co_return narrowed;
  const double low = grip_height * domain_.cube_mm();
  const double high = options_.travel_height_mm;
  const std::string ways[] = {
      move_to(push->from_mm.x(), push->from_mm.y(), high), move_to(push->from_mm.x(), push->from_mm.y(), low),
      move_to(push->to_mm.x(), push->to_mm.y(), low), move_to(push->to_mm.x(), push->to_mm.y(), high)};
  Result<void> done = co_await arm_.face(0);
  for (std::size_t i = 0; done && i < std::size(ways); ++i) {
    done = check();
    if (!done) break;
    const bool pushes = i == 2;
    const Datum speed = list("speed"_sym, pushes ? careful_percent : usual_percent);
    const Datum operation = list("do-action"_sym, ways[i]);
    Result<Datum> moved = co_await arm_.ask(speed);
    if (moved) moved = co_await arm_.ask(operation);
    if (!moved) done = fail(moved);
  }
  const Datum usual = list("speed"_sym, usual_percent);
  const Result<Datum> restored = co_await arm_.ask(usual);
  if (!restored && done) co_return fail(restored);
  co_return done;
}

}  // namespace pizarra
