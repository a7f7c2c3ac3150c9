#include "blackboard/cluster/log_address.hpp"

#include <algorithm>
#include <cctype>

namespace pizarra::cluster {

namespace {

std::unexpected<Failure> bad_address(const std::string& sentence, const std::string& text) {
  return fail("bad-address", sentence, to_datum(text));
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
    std::string member = text.substr(from, end - from);
    if (member.empty()) return bad_address("a member of the cluster has no name", text);
    if (member.find(':') == std::string::npos) member += ":2379";
    address.members.push_back(std::move(member));
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

}  // namespace pizarra::cluster
