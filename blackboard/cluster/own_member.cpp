#include "blackboard/cluster/own_member.hpp"

#include <algorithm>
#include <memory>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include "blackboard/cluster/log_address.hpp"

namespace pizarra::cluster {

namespace {

// The kernel binds a socket to no address but the host's own.
bool is_own(const addrinfo& address) {
  const int file = socket(address.ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (file < 0) return false;
  const bool bound = bind(file, address.ai_addr, address.ai_addrlen) == 0;
  close(file);
  return bound;
}

bool is_on_this_host(const std::string& member) {
  const std::string host = host_and_port(member).host;
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &wanted, &found) != 0) return false;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, freeaddrinfo);
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    if (is_own(*address)) return true;
  }
  return false;
}

}  // namespace

std::size_t own_member(const std::vector<std::string>& members) {
  const auto own = std::ranges::find_if(members, is_on_this_host);
  return own == members.end() ? 0 : static_cast<std::size_t>(own - members.begin());
}

}  // namespace pizarra::cluster
