#include "blackboard/streams/listen_address.hpp"

#include <arpa/inet.h>
#include <array>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "blackboard/streams/file.hpp"
#include "blackboard/wire/wire_address.hpp"

namespace pizarra::streams {

namespace {

constexpr std::string_view tcp = "tcp://";
// Set aside for examples (RFC 5737, RFC 3849): nobody has them, and the way there is the way out.
constexpr const char* somewhere = "192.0.2.1";
constexpr const char* somewhere_in_ipv6 = "2001:db8::1";

std::string host_of(const std::string& address) {
  const std::string host = address.substr(tcp.size(), address.rfind(':') - tcp.size());
  if (host == "[::]") return somewhere_in_ipv6;
  if (host.starts_with('[')) return host.substr(1, host.size() - 2);
  return host == "*" || host == "0.0.0.0" ? somewhere : host;
}

bool is_for_others(const sockaddr_storage& own) {
  constexpr std::uint32_t loopback_net = 127;
  if (own.ss_family == AF_INET6) {
    const in6_addr& address = reinterpret_cast<const sockaddr_in6&>(own).sin6_addr;
    return !IN6_IS_ADDR_LOOPBACK(&address) && !IN6_IS_ADDR_LINKLOCAL(&address);
  }
  const std::uint32_t address = ntohl(reinterpret_cast<const sockaddr_in&>(own).sin_addr.s_addr);
  return own.ss_family == AF_INET && address >> 24 != loopback_net;
}

// A datagram socket that is connected sends nothing, but knows its own end of the way. In figures; empty where there is
// no way, or one that other machines do not come.
std::string own_end(const addrinfo& there) {
  sockaddr_storage own{};
  socklen_t size = sizeof own;
  const auto name = reinterpret_cast<sockaddr*>(&own);
  const File way(socket(there.ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const bool known =
      way && connect(way.number(), there.ai_addr, there.ai_addrlen) == 0 && getsockname(way.number(), name, &size) == 0;
  if (!known || !is_for_others(own)) return {};
  std::array<char, NI_MAXHOST> text{};
  const int untold = getnameinfo(name, size, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST);
  return untold == 0 ? text.data() : "";
}

}  // namespace

std::string stream_listen_address(const std::string& board_address) {
  if (!wire::check_address(board_address) || wire::is_ipc(board_address)) return {};
  const bool ipv6 = wire::is_ipv6(board_address);
  addrinfo hints{};
  hints.ai_family = ipv6 ? AF_INET6 : AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* there = nullptr;
  // Any port will do: 9 is for discarding.
  if (getaddrinfo(host_of(board_address).c_str(), "9", &hints, &there) != 0) return {};
  const std::string own = own_end(*there);
  freeaddrinfo(there);
  if (own.empty()) return {};
  return std::string(tcp) + (ipv6 ? "[" + own + "]" : own) + ":*";
}

}  // namespace pizarra::streams
