#pragma once

// The network card of a host that is a namespace: IP packets that the host sends are read from it, what is written to
// it the host receives.
//
//   TunDevice card("pz-arm", "10.83.0.1");           // throws std::system_error; needs root

#include <optional>
#include <string>

#include "tests/network/packet_line.hpp"

namespace pizarra::network {

class TunDevice {
 public:
  // With a /24 around the address, in the namespace of `ip netns`.
  TunDevice(const std::string& name_space, const std::string& address);
  TunDevice(const TunDevice&) = delete;
  TunDevice& operator=(const TunDevice&) = delete;
  ~TunDevice();

  int file() const { return file_; }
  // Nothing where none waits.
  std::optional<Packet> read() const;
  // What the host has no room for is lost.
  void write(const Packet& packet) const;

 private:
  int file_ = -1;
};

}  // namespace pizarra::network
