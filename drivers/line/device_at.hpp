#pragma once

// How a failure names a device: by what it is and, where there is one, the place at which a person finds it.
//
//   device_at("the controller", wire.place()) + " does not answer"

#include <string>

namespace pizarra::line {

inline std::string device_at(std::string device, const std::string& place) {
  return place.empty() ? device : device + " at " + place;
}

}  // namespace pizarra::line
