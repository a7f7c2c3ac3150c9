#pragma once

// Ports of 127.0.0.1 for the servers that a test starts.
//
//   const int port = free_port();
//   ...start a server there...
//   wait_until([&] { return can_connect(port); });
//
// They lie below those that the system gives to connections (ip_local_port_range, 32768 and above where nobody changed
// it): a connection that is open, or was a minute ago, keeps its port from every server. No port is given twice by one
// process, and processes begin at different ones.

namespace pizarra {

// Nobody listens there.
int free_port();
// The first of two, one behind the other.
int two_free_ports();
// Whether somebody listens there.
bool can_connect(int port);

}  // namespace pizarra
