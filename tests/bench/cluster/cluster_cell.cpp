#include "tests/bench/cluster/cluster_cell.hpp"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "lisp/installed_program.hpp"
#include "tests/bench/cluster/awaited.hpp"
#include "tests/network/connection.hpp"

namespace pizarra::bench {

namespace {

constexpr int board_port = 7943;

constexpr int client_port = 2379;
constexpr int patience_ms = 150;
constexpr std::chrono::seconds until_one_leads(10);

// What a member says of itself, as JSON; empty where it says nothing.
std::string status_of_member(const std::string& address) {
  const std::optional<int> file = network::connect_to(address, client_port);
  if (!file) return "";
  const std::string question =
      "POST /v3/maintenance/status HTTP/1.0\r\nContent-Type: application/json\r\nContent-Length: 2\r\n\r\n{}";
  std::string said;
  if (send(*file, question.data(), question.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(question.size())) {
    pollfd reading{*file, POLLIN, 0};
    std::array<char, 4096> bytes{};
    while (poll(&reading, 1, patience_ms) == 1) {
      const ssize_t size = read(*file, bytes.data(), bytes.size());
      if (size <= 0) break;
      said.append(bytes.data(), static_cast<std::size_t>(size));
    }
  }
  close(*file);
  return said;
}

// The number, as a string, that a member gives under that name; empty where it gives none.
std::string number_in(const std::string& json, const std::string& name) {
  const std::string key = "\"" + name + "\":\"";
  const std::size_t begun = json.find(key);
  if (begun == std::string::npos) return "";
  return json.substr(begun + key.size(), json.find('"', begun + key.size()) - begun - key.size());
}

}  // namespace

std::string ClusterCell::unavailable() {
  if (!installed_program("etcd")) return "etcd is not installed: etcd-server";
  return network::Network::unavailable();
}

ClusterCell::ClusterCell(network::Network::Wires wires, std::string third_disk)
    : third_disk_(std::move(third_disk)), network_("bench", {host(0), host(1), host(2), beside}, wires) {
  for (std::size_t number = 0; number < members; ++number) start_member(number);
  for (std::size_t number = 0; number < most_boards; ++number) start_board(number);
}

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
  const std::string disk = number == 2 && !third_disk_.empty() ? third_disk_ : folder_.path();
  const std::vector<std::string> words = {*installed_program("etcd"),
                                          fmt::format("--name=m{}", number),
                                          fmt::format("--data-dir={}/m{}", disk, number),
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
  const std::vector<std::string> words = {"/bin/sh",
                                          "-c",
                                          "file=$1; shift; exec \"$@\" 2>\"$file\"",
                                          "sh",
                                          complaints_of(number),
                                          program_beside("pizarra-board"),
                                          "--listen",
                                          address_of(number),
                                          "--insecure",
                                          "--log",
                                          log(),
                                          "--log-insecure"};
  boards_.emplace(number, Child::program(network_.on(host(number), words)));
}

std::string ClusterCell::last_complaint(std::size_t board) const {
  std::ifstream complaints(complaints_of(board));
  std::string newest;
  for (std::string line; std::getline(complaints, line);) newest = line;
  return newest;
}

std::string ClusterCell::complaints_of(std::size_t board) const {
  return fmt::format("{}/board-{}.log", folder_.path(), board);
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
    if (network::listens(network_.address(host(number)), board_port)) return number;
  }
  return most_boards;
}

std::size_t ClusterCell::leading_member() const {
  for (const auto& [number, member] : members_) {
    const std::string status = status_of_member(network_.address(host(number)));
    const std::string leader = number_in(status, "leader");
    if (!leader.empty() && leader == number_in(status, "member_id")) return number;
  }
  return members;
}

std::size_t ClusterCell::await_leading_board() const {
  return awaited([this] { return leading_board(); }, most_boards, "no board leads", until_one_leads);
}

std::size_t ClusterCell::await_leading_member() const {
  return awaited([this] { return leading_member(); }, members, "no member of etcd leads", until_one_leads);
}

}  // namespace pizarra::bench
