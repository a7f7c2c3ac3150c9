#include "blackboard/cluster/log_address.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>

#include "blackboard/wire/loopback.hpp"

namespace pizarra::cluster {

namespace {

constexpr int usual_port = 2379;

std::unexpected<Failure> bad_address(const std::string& sentence, const std::string& text) {
  return fail("bad-address", sentence, to_datum(text));
}

bool is_sound(std::string_view text) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; };
  return !text.empty() && text.size() <= 128 && std::ranges::all_of(text, allowed);
}

bool is_host(const std::string& text) {
  if (!text.starts_with('[')) return is_sound(text);
  in6_addr bytes{};
  return text.ends_with(']') && inet_pton(AF_INET6, text.substr(1, text.size() - 2).c_str(), &bytes) == 1;
}

std::optional<int> port_from(std::string_view text) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), port);
  const bool whole = error == std::errc() && end == text.end();
  return whole && port >= 1 && port <= 65535 ? std::optional(port) : std::nullopt;
}

// HOST:PORT of HOST or HOST:PORT; nothing where it is neither.
std::optional<std::string> with_port(const std::string& member) {
  const std::size_t host_ends =
      std::min(member.find(':', member.starts_with('[') ? member.find(']') : 0), member.size());
  const std::string host = member.substr(0, host_ends);
  const std::optional<int> port = host_ends == member.size()
                                      ? std::optional(usual_port)
                                      : port_from(std::string_view(member).substr(host_ends + 1));
  if (!is_host(host) || !port) return std::nullopt;
  return fmt::format("{}:{}", host, *port);
}

bool is_on_loopback(const std::string& member) { return wire::is_loopback(member.substr(0, member.rfind(':'))); }

}  // namespace

Result<LogAddress> LogAddress::from(const std::string& text, const std::string& certificates, bool insecure) {
  if (!is_string_text(text)) return fail("bad-address", "the log's address is not text");
  LogAddress address{.text = text, .members = {}, .cell = {}, .certificates = certificates};
  constexpr std::string_view scheme = "etcd://";
  const std::size_t slash = text.find('/', scheme.size());
  if (!is_one(text) || slash == std::string::npos) {
    return bad_address("a log's address is etcd://A,B,C/CELL, each of A, B and C HOST or HOST:PORT", text);
  }
  address.cell = text.substr(slash + 1);
  if (!is_sound(address.cell))
    return bad_address("behind the members stands the cell's name, of letters, digits, - _ .", text);
  for (std::size_t from = scheme.size(); from <= slash;) {
    const std::size_t end = std::min(text.find(',', from), slash);
    const std::optional<std::string> member = with_port(text.substr(from, end - from));
    if (!member) {
      return bad_address(
          "a member of the cluster is HOST or HOST:PORT, a port from 1 to 65535, an address of IPv6 in brackets: "
          "[fd00::1]",
          text);
    }
    if (std::ranges::count(address.members, *member) > 0) {
      return bad_address("a member of the cluster is named twice: " + *member, text);
    }
    address.members.push_back(*member);
    from = end + 1;
  }
  if (certificates.empty() && !insecure && !std::ranges::all_of(address.members, is_on_loopback)) {
    return fail("not-loopback",
                "other machines reach these members: name the folder of ca.crt, client.crt and client.key with "
                "--log-certificates DIR, or give --log-insecure to go there unencrypted",
                to_datum(text));
  }
  return address;
}

HostPort host_and_port(const std::string& member) {
  const std::size_t colon = member.rfind(':');
  std::string host = member.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  return {host, std::atoi(member.c_str() + colon + 1)};
}

}  // namespace pizarra::cluster
