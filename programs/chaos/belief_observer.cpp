#include "programs/chaos/belief_observer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "lisp/writer.hpp"
#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

namespace {

using Cube = story::WorldState::Cube;

constexpr Duration may_be_wrong = 1s;
constexpr double still_mm = 3;
constexpr double whole = 1;  // of a mark's pixels
constexpr double most_turned_deg = 35;
// The eyes of this camera measure depth to a few millimetres, and a target that is moved by 14 is aimed at anew.
constexpr double elsewhere_mm = 25;
constexpr double nearly_closed_mm = 10;

Eigen::Vector3d at_mm(const Cube& cube) { return {cube.x_mm, cube.y_mm, cube.z_mm}; }

// The directions in which its four sides look.
std::array<Eigen::Vector3d, 4> side_normals(const Cube& cube) {
  std::array<Eigen::Vector3d, 4> normals;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = (cube.yaw_deg + 90 * quarter) * std::numbers::pi / 180;
    normals[static_cast<std::size_t>(quarter)] = {std::cos(angle), std::sin(angle), 0};
  }
  return normals;
}

// That of the side that is turned to the camera most.
Eigen::Vector3d facing(const Eigen::Vector3d& camera_mm, const Cube& cube) {
  const Eigen::Vector3d to_camera = camera_mm - at_mm(cube);
  const auto normals = side_normals(cube);
  return *std::ranges::max_element(normals, {}, [&](const Eigen::Vector3d& normal) { return to_camera.dot(normal); });
}

double turned_deg(const Eigen::Vector3d& camera_mm, const Cube& cube) {
  const double cosine = (camera_mm - at_mm(cube)).normalized().dot(facing(camera_mm, cube));
  return std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
}

bool in_plain_sight(const Eigen::Vector3d& camera_mm, const Cube& cube) {
  const bool stands = !cube.gone && !cube.loose;
  return stands && cube.visible >= whole && turned_deg(camera_mm, cube) <= most_turned_deg;
}

std::set<Datum> as_set(const Result<std::vector<Datum>>& facts) {
  if (!facts) return {};
  return {facts->begin(), facts->end()};
}

}  // namespace

ToldBeliefs told_on(const memory::MemoryBoard* board) {
  ToldBeliefs told;
  for (const Datum& fact : facts_of(board, "(place ? ? ? ? ?)")) {
    const Eigen::Vector3d at(fact[2].number(), fact[3].number(), fact[4].number());
    told.places.emplace(story::in_small_letters(fact[1]).text(), at);
  }
  for (const Datum& fact : facts_of(board, "(believed ?)")) told.facts.insert(story::in_small_letters(fact[1]));
  return told;
}

void BeliefObserver::look(const Moment& moment) {
  note_lying(moment);
  Wrong wrong;
  if (moment.quiet) {
    wrong = wrong_places(moment);
    wrong.merge(wrong_facts(moment));
  }
  std::erase_if(wrong_since_, [&](const auto& known) { return !wrong.contains(known.first); });
  for (const auto& [what, sentence] : wrong) {
    const Time since = wrong_since_.emplace(what, moment.now).first->second;
    if (moment.now - since > may_be_wrong && said_.insert(what).second) unsafe_(sentence);
  }
}

void BeliefObserver::note_lying(const Moment& moment) {
  for (const auto& [name, cube] : moment.world->cubes) {
    const auto before = lying_.find(name);
    const bool is_in_sight = in_plain_sight(camera_mm_, cube);
    const bool stays = before != lying_.end() && (before->second.at_mm - at_mm(cube)).norm() < still_mm;
    if (!is_in_sight) {
      lying_.erase(name);
    } else if (!stays) {
      lying_.insert_or_assign(name, Lying{at_mm(cube), moment.now});
    }
  }
}

bool BeliefObserver::is_steady(const std::string& name, Time now) const {
  const auto found = lying_.find(name);
  return found != lying_.end() && now > found->second.since;
}

// From the middle of a side that shows: several of them may bear the mark, and the eyes may follow any of these.
double BeliefObserver::off_mm(const std::string& name, const Cube& cube, const Eigen::Vector3d& place_mm) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& normal : side_normals(cube)) {
    const Eigen::Vector3d mark_mm = at_mm(cube) + judge_.edge_mm(name) / 2 * normal;
    if ((camera_mm_ - mark_mm).dot(normal) > 0) least = std::min(least, (place_mm - mark_mm).norm());
  }
  return least;
}

BeliefObserver::Wrong BeliefObserver::wrong_places(const Moment& moment) const {
  Wrong wrong;
  for (const auto& [name, cube] : moment.world->cubes) {
    if (!is_steady(name, moment.now)) continue;
    const auto told = moment.told.places.find(name);
    const std::string sight = fmt::format("in plain sight, turned by {:.0f} degrees", turned_deg(camera_mm_, cube));
    if (told == moment.told.places.end()) {
      wrong.emplace(name, fmt::format("nothing is believed of where {} is, which is {}", name, sight));
      continue;
    }
    const double off = off_mm(name, cube, told->second);
    if (off <= elsewhere_mm) continue;
    wrong.emplace(name, fmt::format("{} is believed {:.0f} mm from where it is {}", name, off, sight));
  }
  return wrong;
}

// Any cube may stand on any other: where one is out of sight, or believed to be though it is gone, nobody knows what
// is clear.
bool BeliefObserver::all_in_sight(const Moment& moment) const {
  return std::ranges::all_of(moment.world->cubes, [&](const auto& known) {
    const auto& [name, cube] = known;
    const bool is_away = cube.gone && !moment.told.places.contains(name);
    return is_away || is_steady(name, moment.now);
  });
}

// Whether the fingers stand around a cube, nearly closed and not on it: no sensor of theirs tells that from holding.
bool BeliefObserver::may_hold(const Moment& moment) const {
  const auto is_held = [](const auto& known) { return known.second.held; };
  const auto is_as_wide = [&](const auto& known) {
    return std::abs(moment.opening_mm - judge_.edge_mm(known.first)) < nearly_closed_mm;
  };
  const auto& cubes = moment.world->cubes;
  return std::ranges::none_of(cubes, is_held) && std::ranges::any_of(cubes, is_as_wide);
}

// The domain's rules have bounds, near which a few millimetres decide: a fact is wrong where it is so both of the cubes
// as they lie and of the cubes as they are believed to lie.
BeliefObserver::Wrong BeliefObserver::wrong_facts(const Moment& moment) const {
  if (!all_in_sight(moment) || may_hold(moment)) return {};
  const std::set<Datum> of_world = as_set(judge_.facts(*moment.world));
  const std::set<Datum> of_places = as_set(judge_.facts(as_told(moment)));
  Wrong wrong;
  for (const Datum& fact : moment.told.facts) {
    if (of_world.contains(fact) || of_places.contains(fact)) continue;
    wrong.emplace(write(fact), fmt::format("{} is believed, and the world does not show it", write(fact)));
  }
  for (const Datum& fact : of_world) {
    if (!of_places.contains(fact) || moment.told.facts.contains(fact)) continue;
    wrong.emplace(write(fact), fmt::format("{} is in plain sight, and not believed", write(fact)));
  }
  return wrong;
}

// The judge takes the mark to be before the middle, along x.
story::WorldState BeliefObserver::as_told(const Moment& moment) const {
  story::WorldState told = *moment.world;
  for (auto& [name, cube] : told.cubes) {
    const auto place = moment.told.places.find(name);
    if (place == moment.told.places.end()) continue;
    cube.x_mm = place->second.x() - judge_.edge_mm(name) / 2;
    cube.y_mm = place->second.y();
    cube.z_mm = place->second.z();
  }
  return told;
}

}  // namespace pizarra::chaos
