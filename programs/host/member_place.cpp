#include "programs/host/member_place.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include "blackboard/cluster/log_address.hpp"
#include "blackboard/streams/file.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::host {

namespace {

namespace files = std::filesystem;

// 0, or the reason: as a server would listen there.
int why_not_listening(const addrinfo& address) {
  const streams::File file(socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!file) return errno;
  const int yes = 1;
  setsockopt(file.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool listens = bind(file.number(), address.ai_addr, address.ai_addrlen) == 0 && listen(file.number(), 1) == 0;
  return listens ? 0 : errno;
}

}  // namespace

Result<void> make_member_folder(const std::string& folder) {
  std::error_code refused;
  const bool made = files::create_directories(folder, refused);
  if (made) files::permissions(folder, files::perms::owner_all, refused);
  if (refused) {
    return fail("cannot-write",
                fmt::format("the member's folder cannot be made: {}: {}", text_of_bytes(folder), refused.message()));
  }
  if (access(folder.c_str(), R_OK | W_OK | X_OK) == 0) return {};
  return fail("cannot-write",
              fmt::format("the member's folder cannot be used: {}: {}", text_of_bytes(folder), std::strerror(errno)));
}

Result<void> check_member_certificates(const std::string& folder) {
  if (folder.empty()) return {};
  for (const char* name : {"ca.crt", "server.crt", "server.key"}) {
    const std::string file = folder + "/" + name;
    if (access(file.c_str(), R_OK) == 0) continue;
    return fail("bad-address",
                fmt::format("the member's certificates cannot be read: {}: {}. --log-certificates names their folder",
                            text_of_bytes(file), std::strerror(errno)));
  }
  return {};
}

Result<void> check_member_port(const std::string& place) {
  const cluster::HostPort at = cluster::host_and_port(place);
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int unknown = getaddrinfo(at.host.c_str(), std::to_string(at.port).c_str(), &wanted, &found);
  if (unknown != 0) return fail("bad-address", fmt::format("{}: {}", place, gai_strerror(unknown)));
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, freeaddrinfo);
  const int why = why_not_listening(*addresses);
  if (why == 0) return {};
  if (why == EADDRNOTAVAIL) {
    return fail("bad-address", fmt::format("{} is no address of this machine: --log-here says which member of --log "
                                           "runs here",
                                           at.host));
  }
  if (why != EADDRINUSE) return fail("cannot-listen", fmt::format("{}: {}", place, std::strerror(why)));
  return fail("cannot-listen",
              fmt::format("{} is taken. Where another cell's member runs there, leave out --log-here: one log serves "
                          "several cells. Or give the members of this log other ports, in --log on all hosts",
                          place));
}

}  // namespace pizarra::host
