#include "blackboard/cluster/log_address.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>

namespace pizarra::cluster {

namespace {

std::unexpected<Failure> bad_address(const std::string& sentence, const std::string& text) {
  return fail("bad-address", sentence, to_datum(text));
}

// HOST:PORT of HOST or HOST:PORT; nothing where it is neither.
std::optional<std::string> with_port(const std::string& member) {
  const bool in_brackets = member.starts_with('[');
  const std::size_t host_ends = in_brackets ? member.find(']') : member.find(':');
  if (member.empty() || (in_brackets && host_ends == std::string::npos)) return std::nullopt;
  const std::string rest = host_ends == std::string::npos ? "" : member.substr(host_ends + (in_brackets ? 1 : 0));
  if (rest.empty()) return member + ":2379";
  const bool has_port = rest.starts_with(':') && rest.find(':', 1) == std::string::npos;
  return has_port ? std::optional(member) : std::nullopt;
}

bool is_loopback(const std::string& member) {
  return member.starts_with("127.") || member.starts_with("localhost:") || member.starts_with("[::1]");
}

bool is_sound(const std::string& text) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; };
  return !text.empty() && text.size() <= 128 && std::ranges::all_of(text, allowed);
}

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
      return bad_address("a member of the cluster is HOST or HOST:PORT, an address of IPv6 in brackets: [fd00::1]",
                         text);
    }
    address.members.push_back(*member);
    from = end + 1;
  }
  if (certificates.empty() && !insecure && !std::ranges::all_of(address.members, is_loopback)) {
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
  return {host, colon == std::string::npos ? 0 : std::atoi(member.c_str() + colon + 1)};
}

}  // namespace pizarra::cluster
