#pragma once

// Three hosts in network namespaces, each with a member of an etcd cluster, boards on the first two; and a host beside
// them, from where a bench may look on.
//
//   ClusterCell cell(network::Network::Wires::veth);       // throws where it cannot be had
//   cell.boards()                            // "tcp://10.83.0.1:7943,tcp://10.83.0.2:7943"
//   cell.kill_board(cell.await_leading_board());
//   cell.start_board(0);
//   cell.network().link(cell.host(2), "in cut");           // where its wires are forwarded

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/child.hpp"
#include "tests/network/network.hpp"

namespace pizarra::bench {

class ClusterCell {
 public:
  static constexpr std::size_t members = 3;
  static constexpr std::size_t most_boards = 2;
  // Why it cannot be had here; empty where it can.
  static std::string unavailable();

  // The third member keeps its data in that folder, where one is named, and is told to.
  explicit ClusterCell(network::Network::Wires wires, std::string third_disk = "");
  network::Network& network() { return network_; }
  static std::string host(std::size_t number) { return "pc" + std::to_string(number); }
  // For the calling process and the threads that it starts from then on.
  void enter(std::size_t number) const { network_.enter(host(number)); }
  void enter_the_host_beside() const { network_.enter(beside); }
  std::string log() const;
  std::string boards() const;
  std::string address_of(std::size_t board) const;
  void start_member(std::size_t number);
  void kill_member(std::size_t number) { members_.erase(number); }
  void start_board(std::size_t number);
  void kill_board(std::size_t number) { boards_.erase(number); }
  // Null where it is not running.
  const Child* board(std::size_t number) const { return found(boards_, number); }
  const Child* member(std::size_t number) const { return found(members_, number); }
  // What that board said last of its troubles; empty: nothing since its newest start.
  std::string last_complaint(std::size_t board) const;
  // Everything on its host but the wires, which are cut first and laid again.
  void kill_host(std::size_t number);
  // Those that are not running.
  void start_what_was_killed();
  // Of the boards, who listens; of the members, who says so: as far as this process reaches them. most_boards or
  // members where none does.
  std::size_t leading_board() const;
  std::size_t leading_member() const;
  // The same, where there should be one: throws where there is none for 10 s.
  std::size_t await_leading_board() const;
  std::size_t await_leading_member() const;

 private:
  std::string complaints_of(std::size_t board) const;
  static constexpr const char* beside = "beside";
  static const Child* found(const std::map<std::size_t, Child>& children, std::size_t number) {
    const auto child = children.find(number);
    return child == children.end() ? nullptr : &child->second;
  }

  TemporaryFolder folder_;
  const std::string third_disk_;
  network::Network network_;
  std::map<std::size_t, Child> members_;
  std::map<std::size_t, Child> boards_;
};

}  // namespace pizarra::bench
