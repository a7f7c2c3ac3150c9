#include <fmt/format.h>

#include "agents/coordinator/task_runner.hpp"

namespace pizarra {

namespace {

// How high a mark may stand whose cube is taken to lie on the table, in cube sizes.
constexpr double lies_below = 0.8;

std::string move_to(double x_mm, double y_mm, double z_mm) {
  return fmt::format("(move {:.2f} {:.2f} {:.2f})", x_mm, y_mm, z_mm);
}

}  // namespace

std::optional<Push> TaskRunner::push_for(std::string_view object) const {
  const Sightings& sightings = surroundings_.sightings();
  const Sighting* target = sightings.find(object);
  if (!target || target->place_mm.z() > lies_below * domain_.cube_mm()) return std::nullopt;
  const Eigen::Vector3d behind = options_.gripper.mark_before_grip_mm * surroundings_.view()->away();
  std::vector<Eigen::Vector3d> others;
  for (const auto& [name, sighting] : sightings.all()) {
    if (name != object && name != options_.gripper.mark) others.push_back(sighting.place_mm + behind);
  }
  ElbowRoom room;
  room.cube_mm = domain_.cube_mm();
  room.finger_mm = options_.gripper.finger_mm;
  room.narrow_mm = options_.gripper.narrow_mm;
  return push_for_room(room, target->place_mm + behind, others);
}

Task<Result<void>> TaskRunner::make_room(std::string object) {
  const std::optional<Push> push = push_for(object);
  if (!push) co_return Result<void>();
  const std::string sentence = fmt::format("{} stands too close to its neighbour: pushing it out of the row", object);
  co_await story_.tell("servo", sentence, Datum::symbol(object));
  const double pusher_mm = ElbowRoom().pusher_mm;
  const Result<void> narrowed = co_await open(pusher_mm);
  if (!narrowed) co_return narrowed;
  const double low = domain_.cube_mm() / 2;
  const double high = options_.travel_height_mm;
  const std::string ways[] = {
      move_to(push->from_mm.x(), push->from_mm.y(), high), move_to(push->from_mm.x(), push->from_mm.y(), low),
      move_to(push->to_mm.x(), push->to_mm.y(), low), move_to(push->to_mm.x(), push->to_mm.y(), high)};
  for (const std::string& way : ways) {
    const Result<void> fine = check();
    if (!fine) co_return fine;
    const Datum operation = list("do-action"_sym, way);
    const Result<Datum> moved = co_await arm_.ask(operation);
    if (!moved) co_return fail(moved);
  }
  co_return Result<void>();
}

}  // namespace pizarra
