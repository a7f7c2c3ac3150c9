#pragma once

// Where devices come to: a TCP port of this machine alone, or a serial line.
//
//   tcp_place_from("127.0.0.1:7801")         // localhost:7801 is the same; port 0: any that is free
//   serial_place_from("/dev/ttyUSB0:9600")   // 115200 baud where nothing is said

#include <cstdint>
#include <string>

#include "lisp/result.hpp"

namespace pizarra::door {

struct TcpPlace {
  std::string address;
  std::uint16_t port = 0;
};

struct SerialPlace {
  std::string path;
  int baud = 115200;
};

// Failures: bad-address; not-loopback, for what is said there is neither encrypted nor proved.
Result<TcpPlace> tcp_place_from(const std::string& text);
// Failure: bad-address.
Result<SerialPlace> serial_place_from(const std::string& text);

}  // namespace pizarra::door
