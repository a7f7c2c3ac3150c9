#pragma once

// ZeroMQ binds to numbers and to names of network interfaces. A cell file names its board's machine, as its clients
// elsewhere look it up: such a name is looked up here as well.
//
//   address_to_bind("tcp://bench:7943");   // "tcp://10.0.0.1:7943"

#include <string>

#include "lisp/result.hpp"

namespace pizarra::wire {

// As ZeroMQ takes it. Failure bad-address where nobody knows the name, or where it stands for this machine's own
// loopback alone: a client elsewhere that looks it up would find itself.
Result<std::string> address_to_bind(const std::string& address);

}  // namespace pizarra::wire
