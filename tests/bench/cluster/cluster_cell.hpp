#pragma once

// Three hosts in network namespaces, each with a member of an etcd cluster; boards on the first two, and the bench's
// own process on the third.
//
//   ClusterCell cell;                        // throws where it cannot be had
//   cell.boards()                            // "tcp://10.83.0.1:7943,tcp://10.83.0.2:7943"
//   cell.kill_board(cell.leader());
//   cell.start_board(0);

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

  ClusterCell();
  // For the calling process and the threads that it starts from then on.
  void enter_the_third_host() const;
  std::string log() const;
  std::string boards() const;
  std::string address_of(std::size_t board) const;
  void start_member(std::size_t number);
  void kill_member(std::size_t number) { members_.erase(number); }
  void start_board(std::size_t number);
  void kill_board(std::size_t number) { boards_.erase(number); }
  // Everything on its host but the wires, which are cut first and laid again.
  void kill_host(std::size_t number);
  // Those that are not running.
  void start_what_was_killed();
  // Of the boards, who listens; of the members, who says so. most_boards or members where none does.
  std::size_t leading_board() const;
  std::size_t leading_member() const;

 private:
  std::string host(std::size_t number) const { return "pc" + std::to_string(number); }

  TemporaryFolder folder_;
  network::Network network_;
  std::map<std::size_t, Child> members_;
  std::map<std::size_t, Child> boards_;
};

}  // namespace pizarra::bench
