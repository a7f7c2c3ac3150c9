#pragma once

// The address of a Unix socket that has a name but no file: gone with its socket, whatever happened to the process.
//
//   const AbstractAddress address("pizarra-stream-1");
//   bind(socket, address.get(), address.size());

#include <algorithm>
#include <string_view>
#include <sys/socket.h>
#include <sys/un.h>

namespace pizarra::streams {

class AbstractAddress {
 public:
  static constexpr std::size_t longest_name = sizeof(sockaddr_un::sun_path) - 1;

  // A longer one is cut.
  explicit AbstractAddress(std::string_view name) : length_(std::min(name.size(), longest_name)) {
    address_.sun_family = AF_UNIX;
    // The name begins after a zero byte.
    std::copy_n(name.begin(), length_, static_cast<char*>(address_.sun_path) + 1);
  }
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address_); }
  socklen_t size() const { return static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length_); }

 private:
  sockaddr_un address_{};
  std::size_t length_;
};

}  // namespace pizarra::streams
