#pragma once

// Whether a host of an address is this machine alone, so that nobody else hears what goes there.
//
//   is_loopback("127.0.0.1"); is_loopback("localhost"); is_loopback("[::1]");

#include <string_view>

namespace pizarra::wire {

// A name may begin with a number and lie anywhere.
inline bool is_loopback(std::string_view host) {
  const bool is_number = host.find_first_not_of("0123456789.") == std::string_view::npos;
  return (is_number && host.starts_with("127.")) || host == "localhost" || host == "[::1]";
}

}  // namespace pizarra::wire
