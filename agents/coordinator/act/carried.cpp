#include "agents/coordinator/act/carried.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

// Fingers that hold something close no further, but for the sensor's error.
constexpr double closed_mm = 5;
// Till it is asked again whether a look has come.
constexpr Duration look_patience = 1s;
// From the middle of a cube to that of one that is carried over it, in cubes: half a cube is left between them, since
// what leans stands higher than its middle says.
constexpr double clearing_cubes = 1.5;
// Above the usual height at most, whatever looks say of how high things stand.
constexpr double most_above_cubes = 2;

}  // namespace

bool Carried::is_lost() const {
  const std::optional<double> opening_mm = surroundings_.scene().opening_mm();
  if (!held_mm_ || !opening_mm || options_.open_loop) return false;
  return *opening_mm < *held_mm_ - closed_mm || !domain_.edge_like(*opening_mm);
}

Result<void> Carried::check() const {
  if (is_lost()) return fail("slipped", "what was carried is not between the fingers any more");
  return Result<void>();
}

Task<Result<void>> Carried::keep(Task<Result<void>> step) {
  Job watching;
  if (held_mm_) watching = context_.executor.spawn(cut_short_when_lost());
  const Result<void> done = co_await step;
  const Result<void> held = check();
  if (!held) {
    held_mm_.reset();
    slipped_ = true;
    co_return held;
  }
  if (!done) go_high();
  co_return done;
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

// An arm that is low may hide what slipped, which counts as there meanwhile. What slipped may cover another.
bool Carried::goes_low() const {
  if (goes_high_ || (!held_mm_ && !slipped_)) return false;
  const Sightings& sightings = surroundings_.scene().sightings();
  return std::ranges::all_of(surroundings_.tracked(), [&](const std::string& name) {
    if (name == options_.gripper.mark) return true;
    const bool shows = sightings.recent(name, options_.belief_looks) || sightings.covered(name);
    return (shows || !slipped_) && sightings.remembered(name, options_.grace_looks);
  });
}

// An object that nobody has seen for long makes it travel no higher than usual: a hand may have taken it away.
double Carried::height_over_all_mm() const {
  const double usual = options_.travel_height_mm;
  const double most = usual + most_above_cubes * domain_.cube_mm();
  const Scene& scene = surroundings_.scene();
  const std::optional<Eigen::Vector3d> grip = scene.grip_mm();
  double height_mm = clearing_cubes * domain_.cube_mm();
  for (const auto& [name, sighting] : scene.sightings().all()) {
    const bool is_held = grip && (sighting.place_mm - *grip).norm() < domain_.cube_mm() / 2;
    if (is_held || name == options_.gripper.mark) continue;
    const double over = scene.centre_mm(name, sighting).z() + clearing_cubes * domain_.cube_mm();
    const bool is_there = scene.sightings().remembered(name, options_.grace_looks);
    height_mm = std::max(height_mm, std::min(over, is_there ? most : usual));
  }
  return height_mm;
}

double Carried::height_mm() const {
  const double over_all = height_over_all_mm();
  return goes_low() ? over_all : std::max(options_.travel_height_mm, over_all);
}

}  // namespace pizarra::coordinator
