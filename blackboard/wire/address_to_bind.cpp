#include "blackboard/wire/address_to_bind.hpp"

#include <arpa/inet.h>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <net/if.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "blackboard/wire/loopback.hpp"

namespace pizarra::wire {

namespace {

constexpr std::string_view before_host = "tcp://";

bool is_taken_as_it_is(const std::string& host) {
  in_addr number{};
  return host == "*" || host.starts_with('[') || inet_pton(AF_INET, host.c_str(), &number) == 1 ||
         if_nametoindex(host.c_str()) != 0;
}

std::string in_figures(const addrinfo& found) {
  std::array<char, INET_ADDRSTRLEN> text{};
  const auto& name = reinterpret_cast<const sockaddr_in&>(*found.ai_addr);
  inet_ntop(AF_INET, &name.sin_addr, text.data(), text.size());
  return text.data();
}

Result<std::string> look_up(const std::string& host, const std::string& address) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* first = nullptr;
  const int unknown = getaddrinfo(host.c_str(), nullptr, &hints, &first);
  if (unknown != 0) {
    return fail("bad-address", fmt::format("the name {} is not known here: {}", host, gai_strerror(unknown)),
                to_datum(address));
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> all(first, freeaddrinfo);
  for (const addrinfo* found = first; found != nullptr; found = found->ai_next) {
    const std::string number = in_figures(*found);
    if (!is_loopback(number)) return number;
  }
  return fail("bad-address",
              fmt::format("on this machine the name {} stands for {}, where no other machine reaches it: write the "
                          "machine's address, or change /etc/hosts",
                          host, in_figures(*first)),
              to_datum(address));
}

}  // namespace

Result<std::string> address_to_bind(const std::string& address) {
  if (!address.starts_with(before_host)) return address;
  const std::size_t colon = address.rfind(':');
  const std::string host = address.substr(before_host.size(), colon - before_host.size());
  if (is_taken_as_it_is(host)) return address;
  const Result<std::string> number = host == "localhost" ? "127.0.0.1" : look_up(host, address);
  if (!number) return fail(number);
  return std::string(before_host) + *number + address.substr(colon);
}

}  // namespace pizarra::wire
