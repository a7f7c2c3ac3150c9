#pragma once

// Where a board may be: `ipc://PATH` or `tcp://HOST:PORT`, an address of IPv6 in brackets. Without keys only this
// machine's own addresses are safe.
//
//   const Result<std::vector<std::string>> boards = addresses_from("tcp://10.0.0.1:7800,tcp://10.0.0.2:7800");
//   const std::string own = ipc_address(folder + "/board.ipc");

#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::wire {

// Failure bad-address.
Result<void> check_address(const std::string& address);

// Of boards that take over from each other, with commas between them: each. Failure bad-address.
Result<std::vector<std::string>> addresses_from(const std::string& list);

bool is_ipc(const std::string& address);
std::string ipc_address(const std::string& path);
// Of an address of ipc.
std::string ipc_path(const std::string& address);

// Whether its host is an address of IPv6: ZeroMQ must be told.
bool is_ipv6(const std::string& address);

// Whether a server may bind there: failures bad-address, not-loopback (unless `open_to_others`: there are keys, or
// insecurity was asked for), and address-in-use when another server answers at the ipc path.
Result<void> check_listening_address(const std::string& address, bool open_to_others);

}  // namespace pizarra::wire
