#include "agents/coordinator/sightings.hpp"

namespace pizarra {

void Sightings::look(std::int64_t frame, const Datum& track, const CameraView& view) {
  ++looks_;
  frame_ = frame;
  for (const Datum& item : track.items().subspan(1)) {
    if (item.size() != 4) continue;
    const Eigen::Vector3d place = view.place(item[1].number(), item[2].number(), item[3].number());
    const std::string name(item[0].text());
    const auto [it, is_new] = seen_.try_emplace(name, Sighting{place, frame, looks_, place, looks_});
    Sighting& sighting = it->second;
    sighting.place_mm = place;
    sighting.frame = frame;
    sighting.look = looks_;
    if ((place - sighting.anchor_mm).norm() > still_mm) {
      sighting.anchor_mm = place;
      sighting.still_since = looks_;
    }
  }
}

const Sighting* Sightings::find(std::string_view name) const {
  const auto it = seen_.find(name);
  return it == seen_.end() ? nullptr : &it->second;
}

bool Sightings::recent(std::string_view name, std::uint64_t looks) const {
  const Sighting* sighting = find(name);
  return sighting && sighting->look + looks > looks_;
}

std::uint64_t Sightings::still_looks(std::string_view name) const {
  const Sighting* sighting = find(name);
  return sighting ? looks_ - sighting->still_since : 0;
}

}  // namespace pizarra
