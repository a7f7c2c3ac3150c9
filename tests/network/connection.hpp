#pragma once

// Whether something listens at an address of the calling thread's network, and a line to it.

#include <optional>
#include <string>

namespace pizarra::network {

// A connection, if there is one within 150 ms; the caller closes it.
std::optional<int> connect_to(const std::string& address, int port);
bool listens(const std::string& address, int port);

}  // namespace pizarra::network
