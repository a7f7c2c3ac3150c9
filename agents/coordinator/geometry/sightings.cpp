#include "agents/coordinator/geometry/sightings.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

constexpr int least_yaw_samples = 3;
constexpr int most_yaw_samples = 12;

}  // namespace

void Sightings::look(std::int64_t frame, std::span<const forms::SeenObject> seen, double pan_deg) {
  ++looks_;
  frame_ = frame;
  for (const forms::SeenObject& object : seen) {
    const Eigen::Vector3d place(object.at_mm[0], object.at_mm[1], object.at_mm[2]);
    const auto [it, is_new] = seen_.try_emplace(object.name, Sighting{place, frame, looks_, place, looks_});
    Sighting& sighting = it->second;
    sighting.longest_gap = std::max(sighting.longest_gap, looks_ - sighting.look);
    sighting.place_mm = place;
    sighting.frame = frame;
    sighting.look = looks_;
    sighting.excused = 0;
    sighting.covered = 0;
    sighting.in_gripper = false;
    if ((place - sighting.anchor_mm).norm() > still_mm) {
      sighting.anchor_mm = place;
      sighting.still_since = looks_;
      sighting.longest_gap = 0;
      sighting.yaw_samples = 0;
    }
    if (object.face_deg) face(sighting, *object.face_deg - pan_deg);
  }
}

void Sightings::excuse(const std::string& name) {
  const auto it = seen_.find(name);
  if (it == seen_.end() || it->second.look == looks_ || it->second.excused == most_excused) return;
  ++it->second.excused;
  ++it->second.look;
}

void Sightings::hold(const std::string& name) {
  const auto it = seen_.find(name);
  if (it != seen_.end()) it->second.in_gripper = true;
}

void Sightings::carry(const std::string& name, const Eigen::Vector3d& place_mm) {
  const auto it = seen_.find(name);
  if (it == seen_.end() || it->second.look == looks_) return;
  it->second.place_mm = place_mm;
  excuse(name);
}

void Sightings::cover(const std::string& name) {
  const auto it = seen_.find(name);
  if (it == seen_.end()) return;
  Sighting& sighting = it->second;
  const std::uint64_t unseen = looks_ - sighting.look;
  const bool is_forgotten = sighting.covered == 0 && unseen > most_patience;
  if (unseen == 0 || is_forgotten || sighting.excused == most_excused) return;
  ++sighting.excused;
  sighting.covered = sighting.covered == 0 ? unseen : sighting.covered + 1;
}

void Sightings::end_excuses() {
  for (auto& [name, sighting] : seen_) {
    if (sighting.excused > 0) sighting.excused = most_excused;
  }
}

// A turn that goes on without moving the mark shows too: old samples weigh less and less.
void Sightings::face(Sighting& sighting, double yaw_deg) {
  if (sighting.yaw_samples == 0) sighting.yaw_deg = yaw_deg;
  sighting.yaw_samples = std::min(sighting.yaw_samples + 1, most_yaw_samples);
  sighting.yaw_deg += (yaw_deg - sighting.yaw_deg) / sighting.yaw_samples;
}

std::optional<double> Sightings::face_deg(std::string_view name) const {
  const Sighting* sighting = find(name);
  if (!sighting || sighting->yaw_samples < least_yaw_samples) return std::nullopt;
  return sighting->yaw_deg;
}

const Sighting* Sightings::find(std::string_view name) const {
  const auto it = seen_.find(name);
  return it == seen_.end() ? nullptr : &it->second;
}

bool Sightings::recent(std::string_view name, std::uint64_t looks) const {
  const Sighting* sighting = find(name);
  return sighting && sighting->look + looks > looks_;
}

bool Sightings::remembered(std::string_view name, int grace) const {
  const Sighting* sighting = find(name);
  if (!sighting) return false;
  const std::uint64_t patience = std::min(2 * sighting->longest_gap, most_patience);
  return recent(name, std::max(static_cast<std::uint64_t>(grace), patience) + sighting->covered);
}

bool Sightings::covered(std::string_view name) const {
  const Sighting* sighting = find(name);
  return sighting && sighting->covered > 0;
}

std::uint64_t Sightings::still_looks(std::string_view name) const {
  const Sighting* sighting = find(name);
  return sighting ? looks_ - sighting->still_since : 0;
}

}  // namespace pizarra::coordinator
