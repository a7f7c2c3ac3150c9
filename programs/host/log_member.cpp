#include "programs/host/log_member.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

#include "lisp/installed_program.hpp"
#include "programs/host/log_meeting.hpp"
#include "programs/host/member_place.hpp"

namespace pizarra::host {

namespace {

constexpr Duration asks_every = 500ms;

// HOST:PORT at which the others speak to a member.
Result<std::string> peer_of(const std::string& member) {
  const int port = cluster::host_and_port(member).port;
  constexpr int highest = 65535;
  if (port == highest) return fail("bad-address", "a member that runs here has a port from 1 to 65534: " + member);
  return fmt::format("{}:{}", member.substr(0, member.rfind(':')), port + 1);
}

// Etcd listens at no other name.
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
  const auto own = std::ranges::find_if(members, [&](const std::string& each) {
    return each == member.here || each.substr(0, each.rfind(':')) == member.here;
  });
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

struct Others {
  cluster::LogAddress between;  // the addresses at which members speak to each other
  std::unique_ptr<cluster::EtcdMembers> members;
  std::unique_ptr<cluster::EtcdClient> client;
};

Result<std::shared_ptr<Others>> others_of(const MemberHere& member, const Peers& peers) {
  const auto others = std::make_shared<Others>();
  others->between = member.log;
  others->between.members = peers.all;
  others->between = without(others->between, peers.own);
  Result<std::unique_ptr<cluster::EtcdMembers>> members =
      cluster::EtcdMembers::open(without(member.log, peers.own), others->between);
  if (!members) return fail(members);
  others->members = std::move(*members);
  Result<std::unique_ptr<cluster::EtcdClient>> client = cluster::EtcdClient::open(others->between);
  if (!client) return fail(client);
  others->client = std::move(*client);
  return others;
}

struct Known {
  Result<std::optional<cluster::Beginning>> begins = std::nullopt;
  std::vector<std::string> silent = {};      // of those that are asked whether they have no data either
  std::vector<std::string> distrusted = {};  // why, of those whose certificate is not believed
};

std::string sentence_of_waiting(const MemberHere& member, const Known& known) {
  std::string sentence = fmt::format(
      "{} has no data, and waits for {}: a new log is begun by all members together, and one that ran takes this "
      "member back while most of the others run",
      member.folder, fmt::join(known.silent, ", "));
  for (const std::string& why : known.distrusted) sentence += "; " + why;
  return sentence;
}

Known ask(const Others& others, const std::string& url) {
  Known known{.begins = cluster::begin_member(*others.members, url)};
  if (known.begins && *known.begins) return known;
  for (std::size_t other = 0; other < others.between.members.size(); ++other) {
    const Result<bool> empty = says_no_data(*others.client, other, others.between);
    if (empty && *empty) continue;
    known.silent.push_back(others.between.members[other]);
    if (!empty && cluster::is_distrusted(empty.error())) known.distrusted.push_back(empty.error().sentence);
  }
  if (known.silent.empty()) known.begins = cluster::Beginning::anew;
  return known;
}

// Asks all others, once.
Task<Known> ask_others(Executor& executor, std::shared_ptr<const Others> others, std::string url) {
  const auto known = std::make_shared<Known>();
  std::function<void(const std::function<bool()>&)> work = [others, url, known](auto&&) { *known = ask(*others, url); };
  co_await executor.offload(std::move(work), Duration::zero());
  co_return *known;
}

}  // namespace

Result<void> check_member(const MemberHere& member) {
  const Result<Peers> peers = peers_of(member);
  if (!peers) return fail(peers);
  const std::string host = cluster::host_and_port(member.log.members[peers->own]).host;
  if (host != "localhost" && !web::is_ip_address(host)) {
    return fail("bad-address", fmt::format("a member that runs here has an address in figures, not {}", host));
  }
  if (!installed_program("etcd")) return fail("no-program", "etcd is not installed: apt install etcd-server");
  return {};
}

Result<void> prepare_member(const MemberHere& member) {
  const Result<void> certificates = check_member_certificates(member.log.certificates);
  return certificates ? make_member_folder(member.folder) : certificates;
}

Result<void> check_ports(const MemberHere& member) {
  const Result<Peers> peers = peers_of(member);
  if (!peers) return fail(peers);
  const Result<void> asked = check_member_port(member.log.members[peers->own]);
  return asked ? check_member_port(peers->all[peers->own]) : asked;
}

bool has_data(const MemberHere& member) { return std::filesystem::exists(member.folder + "/member/wal"); }

Task<Result<cluster::Beginning>> beginning_of(Executor& executor, MemberHere member, Time deadline, SayWaiting say) {
  const Result<Peers> peers = peers_of(member);
  if (!peers) co_return fail(peers);
  if (peers->all.size() == 1) co_return cluster::Beginning::anew;
  const Result<std::shared_ptr<Others>> others = others_of(member, *peers);
  if (!others) co_return fail(others);
  const auto says = say_no_data(executor, peers->all[peers->own], member.log);
  if (!says) co_return fail(says);
  Failure newest{"unavailable", "", {}, {}};
  while (executor.now() < deadline) {
    const Known known = co_await ask_others(executor, *others, peers->url(member, peers->own));
    if (known.begins && *known.begins) co_return **known.begins;
    const Failure waits =
        known.begins ? Failure{"unavailable", sentence_of_waiting(member, known), {}, {}} : known.begins.error();
    if (waits.sentence != newest.sentence) say(waits);
    newest = waits;
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
  std::vector<std::string> command = {installed_program("etcd").value(),
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

}  // namespace pizarra::host
