#pragma once

// Where objects were seen at one time, to tell later whether somebody moved one. An object that goes out of sight has
// not been moved, nor one that comes into sight again where it was: a mark may be hard to see.
//
//   const SeenPlaces before(sightings, "gripper");             // the end effector's mark, which does not count
//   if (std::optional<std::string> name = before.moved(sightings)) ...

#include "agents/coordinator/geometry/sightings.hpp"

namespace pizarra::coordinator {

class SeenPlaces {
 public:
  SeenPlaces(const Sightings& sightings, std::string but);
  // One that lies still elsewhere, or was never seen before.
  std::optional<std::string> moved(const Sightings& sightings) const;

 private:
  std::string but_;
  std::map<std::string, Eigen::Vector3d, std::less<>> places_mm_;
};

}  // namespace pizarra::coordinator
