#include "programs/commands/log_member.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <unistd.h>

#include "programs/commands/log_meeting.hpp"

namespace pizarra::programs {

namespace {

constexpr const char* etcd = "/usr/bin/etcd";
constexpr Duration asks_every = 500ms;

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

// HOST:PORT of each, as the others speak to it, and which is this host's.
struct Peers {
  std::vector<std::string> all;
  std::size_t own = 0;
  std::string url(const MemberHere& member, std::size_t number) const {
    return fmt::format("{}://{}", member.log.certificates.empty() ? "http" : "https", all[number]);
  }
};

Result<Peers> peers_of(const MemberHere& member) {
  const std::vector<std::string>& members = member.log.members;
  const auto own = std::ranges::find_if(
      members, [&](const std::string& each) { return each == member.here || each.starts_with(member.here + ":"); });
  if (own == members.end()) {
    return fail("bad-address", fmt::format("{} is no member of {}", member.here, member.log.text));
  }
  Peers peers{.all = {}, .own = static_cast<std::size_t>(own - members.begin())};
  for (const std::string& each : members) {
    const Result<std::string> peer = peer_of(each);
    if (!peer) return fail(peer);
    peers.all.push_back(*peer);
  }
  return peers;
}

cluster::LogAddress without(cluster::LogAddress log, std::size_t number) {
  log.members.erase(log.members.begin() + static_cast<std::ptrdiff_t>(number));
  return log;
}

std::string sentence_of_waiting(const MemberHere& member, const std::vector<std::string>& silent) {
  return fmt::format(
      "{} has no data, and waits for {}: a new log is begun by all members together, and one that ran takes this "
      "member back while most of the others run",
      member.folder, fmt::join(silent, ", "));
}

using Begins = Result<std::optional<cluster::Beginning>>;

// Asks what the others know of it, once.
Task<Begins> ask_others(Executor& executor, std::shared_ptr<cluster::LogMembers> others, std::string url) {
  const auto begins = std::make_shared<Begins>(std::nullopt);
  std::function<void(const std::function<bool()>&)> work = [others, url, begins](auto&&) {
    *begins = cluster::begin_member(*others, url);
  };
  co_await executor.offload(std::move(work), Duration::zero());
  co_return *begins;
}

}  // namespace

Result<void> check_member(const MemberHere& member) {
  const Result<Peers> peers = peers_of(member);
  if (!peers) return fail(peers);
  if (access(etcd, X_OK) != 0) return fail("no-program", "etcd is not installed: apt install etcd-server");
  return {};
}

bool has_data(const MemberHere& member) { return std::filesystem::exists(member.folder + "/member/wal"); }

Task<Result<cluster::Beginning>> beginning_of(Executor& executor, MemberHere member, Time deadline) {
  const Result<Peers> peers = peers_of(member);
  if (!peers) co_return fail(peers);
  cluster::LogAddress between = without(member.log, peers->own);
  if (between.members.empty()) co_return cluster::Beginning::anew;
  cluster::LogAddress others = between;
  between.members = peers->all;
  between = without(between, peers->own);
  Result<std::unique_ptr<cluster::EtcdMembers>> opened = cluster::EtcdMembers::open(others, between);
  if (!opened) co_return fail(opened);
  const std::shared_ptr<cluster::LogMembers> members = std::move(*opened);
  const auto meeting = LogMeeting::open(executor, peers->all[peers->own], member.log.cell);
  if (!meeting) co_return fail(meeting);
  const Job says = executor.spawn((*meeting)->say());
  Failure newest{"unavailable", "", {}, {}};
  while (executor.now() < deadline) {
    const Begins begins = co_await ask_others(executor, members, peers->url(member, peers->own));
    if (begins && *begins) co_return **begins;
    std::vector<std::string> silent;
    for (const std::string& other : between.members) {
      const bool is_empty = co_await (*meeting)->says_it(other);
      if (!is_empty) silent.push_back(other);
    }
    if (silent.empty()) co_return cluster::Beginning::anew;
    newest = begins ? Failure{"unavailable", sentence_of_waiting(member, silent), {}, {}} : begins.error();
    co_await sleep(executor, asks_every);
  }
  co_return fail(newest);
}

std::vector<std::string> etcd_command(const MemberHere& member, cluster::Beginning begins) {
  const Peers peers = peers_of(member).value();
  const cluster::LogAddress& log = member.log;
  std::string all;
  for (std::size_t number = 0; number < peers.all.size(); ++number) {
    all += fmt::format("{}{}={}", number == 0 ? "" : ",", name_of(number), peers.url(member, number));
  }
  const std::string own = peers.url(member, peers.own);
  const std::string asked = fmt::format("{}://{}", log.certificates.empty() ? "http" : "https", log.members[peers.own]);
  const bool joins = begins == cluster::Beginning::joining;
  std::vector<std::string> command = {etcd,
                                      "--name=" + name_of(peers.own),
                                      "--data-dir=" + std::filesystem::absolute(member.folder).string(),
                                      "--initial-cluster=" + all,
                                      fmt::format("--initial-cluster-state={}", joins ? "existing" : "new"),
                                      "--initial-cluster-token=pizarra-" + log.cell,
                                      "--listen-peer-urls=" + own,
                                      "--initial-advertise-peer-urls=" + own,
                                      "--listen-client-urls=" + asked,
                                      "--advertise-client-urls=" + asked,
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
