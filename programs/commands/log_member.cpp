#include "programs/commands/log_member.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace pizarra::programs {

namespace {

constexpr const char* etcd = "/usr/bin/etcd";

// HOST:PORT at which the others speak to a member.
Result<std::string> peer_of(const std::string& member) {
  const std::size_t colon = member.rfind(':');
  constexpr int highest = 65535;
  const int port = std::atoi(member.c_str() + colon + 1);
  if (port < 1 || port >= highest) return fail("bad-address", "a member has a port from 1 to 65534: " + member);
  return fmt::format("{}:{}", member.substr(0, colon), port + 1);
}

std::string name_of(std::size_t number) { return fmt::format("member-{}", number + 1); }

void add_certificates(std::vector<std::string>& command, const std::string& folder) {
  for (const char* side : {"", "peer-"}) {
    command.push_back(fmt::format("--{}cert-file={}/server.crt", side, folder));
    command.push_back(fmt::format("--{}key-file={}/server.key", side, folder));
    command.push_back(fmt::format("--{}trusted-ca-file={}/ca.crt", side, folder));
    command.push_back(fmt::format("--{}client-cert-auth", side));
  }
}

}  // namespace

Result<std::vector<std::string>> log_member(const cluster::LogAddress& log, const std::string& here,
                                            const std::string& folder) {
  const auto own = std::ranges::find_if(
      log.members, [&](const std::string& member) { return member == here || member.starts_with(here + ":"); });
  if (own == log.members.end()) return fail("bad-address", fmt::format("{} is no member of {}", here, log.text));
  if (access(etcd, X_OK) != 0) return fail("no-program", "etcd is not installed: apt install etcd-server");
  const char* const scheme = log.certificates.empty() ? "http" : "https";
  std::string all;
  for (std::size_t number = 0; number < log.members.size(); ++number) {
    const Result<std::string> peer = peer_of(log.members[number]);
    if (!peer) return fail(peer);
    all += fmt::format("{}{}={}://{}", number == 0 ? "" : ",", name_of(number), scheme, *peer);
  }
  const std::string peer = peer_of(*own).value();
  std::vector<std::string> command = {etcd,
                                      "--name=" + name_of(static_cast<std::size_t>(own - log.members.begin())),
                                      "--data-dir=" + std::filesystem::absolute(folder).string(),
                                      "--initial-cluster=" + all,
                                      "--initial-cluster-token=pizarra-" + log.cell,
                                      fmt::format("--listen-peer-urls={}://{}", scheme, peer),
                                      fmt::format("--initial-advertise-peer-urls={}://{}", scheme, peer),
                                      fmt::format("--listen-client-urls={}://{}", scheme, *own),
                                      fmt::format("--advertise-client-urls={}://{}", scheme, *own),
                                      "--heartbeat-interval=50",
                                      "--election-timeout=500",
                                      "--auto-compaction-retention=5m",
                                      "--quota-backend-bytes=8589934592",
                                      "--snapshot-count=10000",
                                      "--logger=zap",
                                      "--log-level=warn"};
  if (!log.certificates.empty()) add_certificates(command, std::filesystem::absolute(log.certificates).string());
  return command;
}

}  // namespace pizarra::programs
