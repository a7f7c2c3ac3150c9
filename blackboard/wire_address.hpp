#pragma once

// Where a board may be: `ipc://PATH` or `tcp://HOST:PORT`. Without encryption only this machine's own address is safe.

#include <string>

#include "lisp/result.hpp"

namespace pizarra {

// Failure bad-address.
Result<void> check_address(const std::string& address);

// Whether a server may bind there: failures bad-address, not-loopback (unless `insecure`), and address-in-use when
// another server answers at the ipc path.
Result<void> check_listening_address(const std::string& address, bool insecure);

}  // namespace pizarra
