#include "blackboard/wire/wire_address.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cctype>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "blackboard/wire/loopback.hpp"

namespace pizarra::wire {

namespace {

constexpr std::string_view ipc = "ipc://";
constexpr std::string_view tcp = "tcp://";

std::unexpected<Failure> bad_address(std::string sentence, const std::string& address) {
  return fail("bad-address", std::move(sentence), to_datum(address));
}

std::string_view host_of(std::string_view address) {
  return address.substr(tcp.size(), address.rfind(':') - tcp.size());
}

// A host with colons is an address of IPv6, in brackets.
bool is_sound_host(std::string_view host) {
  const bool has_brackets = host.starts_with('[') || host.ends_with(']');
  if (!has_brackets) return !host.empty() && !host.contains(':');
  if (host.size() < 2 || !host.starts_with('[') || !host.ends_with(']')) return false;
  in6_addr bytes{};
  return inet_pton(AF_INET6, std::string(host.substr(1, host.size() - 2)).c_str(), &bytes) == 1;
}

// Binding an ipc path takes it away from a server that lives there, so it is asked first.
bool somebody_answers(const std::string& path) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  std::memcpy(static_cast<char*>(name.sun_path), path.c_str(), path.size() + 1);
  const int probe = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (probe < 0) return false;
  const int connected = connect(probe, reinterpret_cast<const sockaddr*>(&name), sizeof name);
  close(probe);
  return connected == 0;
}

}  // namespace

Result<void> check_address(const std::string& address) {
  // An argument from a command line need not be text that a Datum can hold.
  if (!is_string_text(address)) return fail("bad-address", "the address is not text");
  if (address.starts_with(ipc)) {
    const std::size_t length = address.size() - ipc.size();
    if (length > 0 && length < sizeof(sockaddr_un::sun_path)) return {};
    return bad_address("an ipc path has from 1 to 107 bytes", address);
  }
  if (!address.starts_with(tcp)) return bad_address("a board's address is ipc://PATH or tcp://HOST:PORT", address);
  const std::size_t colon = address.rfind(':');
  const std::string port = address.substr(colon + 1);
  const bool digits = !port.empty() && port.size() <= 5 &&
                      std::ranges::all_of(port, [](unsigned char c) { return std::isdigit(c) != 0; });
  const bool host = is_sound_host(address.substr(tcp.size(), std::max(colon, tcp.size()) - tcp.size()));
  if (host && (port == "*" || (digits && std::stoi(port) <= 65535))) return {};
  return bad_address(
      "a tcp address is tcp://HOST:PORT with a port from 0 to 65535, or * for any; an address of IPv6 is in brackets, "
      "tcp://[::1]:PORT",
      address);
}

Result<std::vector<std::string>> addresses_from(const std::string& list) {
  constexpr std::size_t most = 8;
  // A path may have a comma.
  if (list.starts_with(ipc) || !is_string_text(list)) {
    const Result<void> sound = check_address(list);
    return sound ? Result<std::vector<std::string>>({list}) : fail(sound);
  }
  std::vector<std::string> addresses;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t end = std::min(list.find(',', from), list.size());
    addresses.push_back(list.substr(from, end - from));
    const Result<void> sound = check_address(addresses.back());
    if (!sound) return fail(sound);
    from = end + 1;
  }
  if (addresses.size() > most) return bad_address("a board has 8 addresses at most", list);
  return addresses;
}

bool is_ipc(const std::string& address) { return address.starts_with(ipc); }
std::string ipc_address(const std::string& path) { return std::string(ipc) + path; }
std::string ipc_path(const std::string& address) { return address.substr(ipc.size()); }

bool is_ipv6(const std::string& address) { return address.starts_with("tcp://["); }

Result<void> check_listening_address(const std::string& address, bool open_to_others) {
  const Result<void> formed = check_address(address);
  if (!formed) return formed;
  if (address.starts_with(tcp) && !open_to_others && !is_loopback(host_of(address))) {
    return fail("not-loopback",
                "other machines reach this address: name the folder of the keys that may come with --keys DIR, or give "
                "--insecure to let anybody come unencrypted",
                to_datum(address));
  }
  if (address.starts_with(ipc) && address[ipc.size()] == '@') {
    return bad_address(
        "a socket in no folder is open to everybody on this machine: ipc://PATH has a file, and who may "
        "open that may come",
        address);
  }
  if (address.starts_with(ipc) && somebody_answers(address.substr(ipc.size()))) {
    return fail("address-in-use", "another board answers there", to_datum(address));
  }
  return {};
}

}  // namespace pizarra::wire
