#pragma once

namespace pizarra {

// Whether this machine can be reached at an address of IPv6: its own.
bool has_ipv6();

}  // namespace pizarra
