#pragma once

// Where other processes reach a World: ipc://PATH, a socket with a file.
//
//   if (!is_link_address(text)) return fail("bad-address", "a simulated world is at ipc://PATH");

#include <string_view>

namespace pizarra::simulation {

inline constexpr std::string_view link_scheme = "ipc://";

constexpr bool is_link_address(std::string_view address) { return address.starts_with(link_scheme); }

}  // namespace pizarra::simulation
