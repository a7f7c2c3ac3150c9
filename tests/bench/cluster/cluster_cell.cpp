#include "tests/bench/cluster/cluster_cell.hpp"

#include <arpa/inet.h>
#include <array>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra::bench {

namespace {

constexpr int board_port = 7943;

std::string output_of(const std::string& command) {
  std::string output;
  std::FILE* const pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::array<char, 512> bytes{};
  while (pipe != nullptr && std::fgets(bytes.data(), bytes.size(), pipe) != nullptr) output += bytes.data();
  if (pipe != nullptr) pclose(pipe);
  return output;
}

bool listens(const std::string& address) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(board_port);
  inet_pton(AF_INET, address.c_str(), &name.sin_addr);
  const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  connect(file, reinterpret_cast<const sockaddr*>(&name), sizeof name);
  pollfd connecting{file, POLLOUT, 0};
  constexpr int patience_ms = 100;
  const bool came = poll(&connecting, 1, patience_ms) == 1 && (connecting.revents & (POLLERR | POLLHUP)) == 0;
  close(file);
  return came;
}

}  // namespace

std::string ClusterCell::unavailable() {
  if (!find_program("etcd")) return "etcd is not installed: etcd-server";
  return network::Network::unavailable();
}

ClusterCell::ClusterCell() : network_("bench", {"pc0", "pc1", "pc2"}, network::Network::Wires::veth) {
  for (std::size_t number = 0; number < members; ++number) start_member(number);
  for (std::size_t number = 0; number < most_boards; ++number) start_board(number);
}

void ClusterCell::enter_the_third_host() const { network_.enter(host(2)); }

std::string ClusterCell::log() const {
  return fmt::format("etcd://{},{},{}/bench", network_.address(host(0)), network_.address(host(1)),
                     network_.address(host(2)));
}

std::string ClusterCell::address_of(std::size_t board) const {
  return fmt::format("tcp://{}:{}", network_.address(host(board)), board_port);
}

std::string ClusterCell::boards() const { return address_of(0) + "," + address_of(1); }

void ClusterCell::start_member(std::size_t number) {
  std::string cluster;
  for (std::size_t i = 0; i < members; ++i) {
    cluster += fmt::format("{}m{}=http://{}:2380", i == 0 ? "" : ",", i, network_.address(host(i)));
  }
  const std::string own = network_.address(host(number));
  const std::vector<std::string> words = {*find_program("etcd"),
                                          fmt::format("--name=m{}", number),
                                          fmt::format("--data-dir={}/m{}", folder_.path(), number),
                                          "--initial-cluster=" + cluster,
                                          fmt::format("--listen-peer-urls=http://{}:2380", own),
                                          fmt::format("--initial-advertise-peer-urls=http://{}:2380", own),
                                          fmt::format("--listen-client-urls=http://{}:2379", own),
                                          fmt::format("--advertise-client-urls=http://{}:2379", own),
                                          "--heartbeat-interval=50",
                                          "--election-timeout=500",
                                          "--logger=zap",
                                          fmt::format("--log-outputs={}/m{}.log", folder_.path(), number)};
  members_.emplace(number, Child::program(network_.on(host(number), words)));
}

void ClusterCell::start_board(std::size_t number) {
  // Its complaints about an etcd that was killed belong to no figure.
  const std::vector<std::string> words = {"/bin/sh",
                                          "-c",
                                          "exec \"$@\" 2>/dev/null",
                                          "sh",
                                          program_beside("pizarra-board"),
                                          "--listen",
                                          address_of(number),
                                          "--insecure",
                                          "--log",
                                          log(),
                                          "--log-insecure"};
  boards_.emplace(number, Child::program(network_.on(host(number), words)));
}

void ClusterCell::kill_host(std::size_t number) {
  network_.cut_power(host(number));
  boards_.erase(number);
  members_.erase(number);
}

void ClusterCell::start_what_was_killed() {
  for (std::size_t number = 0; number < members; ++number) {
    if (members_.contains(number)) continue;
    network_.link(host(number), "both");
    start_member(number);
  }
  for (std::size_t number = 0; number < most_boards; ++number) {
    if (!boards_.contains(number)) start_board(number);
  }
}

std::size_t ClusterCell::leading_board() const {
  for (const auto& [number, board] : boards_) {
    if (listens(network_.address(host(number)))) return number;
  }
  return most_boards;
}

std::size_t ClusterCell::leading_member() const {
  for (const auto& [number, member] : members_) {
    const std::string endpoint = network_.address(host(number)) + ":2379";
    const std::string said = output_of("ETCDCTL_API=3 etcdctl --endpoints=" + endpoint + " endpoint status");
    // ENDPOINT, ID, VERSION, SIZE, LEADER, ...
    if (said.find("B, true,") != std::string::npos) return number;
  }
  return members;
}

}  // namespace pizarra::bench
