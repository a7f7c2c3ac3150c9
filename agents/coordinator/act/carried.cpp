#include "agents/coordinator/act/carried.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

// Till it is asked again whether a look has come.
constexpr Duration look_patience = 1s;
// From the middle of a cube to that of one that is carried over it, in cubes: half a cube is left between them, since
// what leans stands higher than its middle says.
constexpr double clearing_cubes = 1.5;

}  // namespace

bool Carried::is_lost() const {
  const std::optional<double> opening_mm = surroundings_.scene().opening_mm();
  return is_carried_ && opening_mm && !domain_.edge_like(*opening_mm) && !options_.open_loop;
}

Task<Result<void>> Carried::keep(Task<Result<void>> step) {
  Job watching;
  if (is_carried_) watching = context_.executor.spawn(cut_short_when_lost());
  const Result<void> done = co_await step;
  if (!is_lost()) co_return done;
  is_carried_ = false;
  co_return fail("slipped", "what was carried is not between the fingers any more");
}

// A step may have several motions left.
Task<void> Carried::cut_short_when_lost() {
  while (true) {
    // A motion that was not stopped goes on to its end.
    if (is_lost()) co_await arm_.cut_short();
    const Time soon = context_.executor.now() + look_patience;
    co_await surroundings_.look_after(surroundings_.looks(), soon);
  }
}

bool Carried::sees_all() const {
  const Scene& scene = surroundings_.scene();
  return std::ranges::all_of(surroundings_.tracked(), [&](const std::string& name) {
    return scene.sightings().remembered(name, options_.grace_looks);
  });
}

// The middle of the highest cube but that in the gripper.
double Carried::highest_mm() const {
  const Scene& scene = surroundings_.scene();
  const std::optional<Eigen::Vector3d> grip = scene.grip_mm();
  double highest_mm = 0;
  for (const auto& [name, sighting] : scene.sightings().all()) {
    const bool is_held = grip && (sighting.place_mm - *grip).norm() < domain_.cube_mm() / 2;
    if (is_held || name == options_.gripper.mark) continue;
    highest_mm = std::max(highest_mm, scene.centre_mm(name, sighting).z());
  }
  return highest_mm;
}

double Carried::height_mm() const {
  if (!goes_low()) return options_.travel_height_mm;
  return std::min(highest_mm() + clearing_cubes * domain_.cube_mm(), options_.travel_height_mm);
}

}  // namespace pizarra::coordinator
