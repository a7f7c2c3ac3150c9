#pragma once

// A cell on three hosts of a test, each with a key of its own: arm-pc (robot, person), eyes-pc (vision), and board-pc
// (board, planner, coordinator). The simulated world is the one thing that they share besides the network.
//
//   CellOnHosts cell({"eyes-pc", "arm-pc", "board-pc"});       // started in this order
//   EXPECT_TRUE(cell.goal("(on circle triangle)").reached) << ...;
//   cell.network().cut_power("arm-pc");
//   cell.network().link("arm-pc", "both");
//   cell.up("arm-pc");
//
// Where its boards take over from each other, each of the three hosts has one, with a member of the log. The world and
// the person are on a fourth, world-pc, which comes first: they do not end with a computer.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/network/network.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"

namespace pizarra::network {

class CellOnHosts {
 public:
  static const std::vector<std::string> hosts;
  static constexpr int board_port = 7943;
  enum class Boards { one, that_take_over };

  // Its eyes know the objects of this folder from the start, or nothing.
  explicit CellOnHosts(Boards boards = Boards::one, const std::string& objects = "");
  Network& network() { return network_; }
  void up(const std::string& host);
  // What `pizarra WORDS` says there, with that host's key.
  programs::Said run(const std::string& host, const std::string& words) const;
  // Whether what the command says comes to have it.
  bool comes(const std::string& host, const std::string& words, const std::string& wanted,
             std::chrono::seconds patience = std::chrono::seconds(90)) const;
  bool all_are_there() const;
  // Where the board listens, or all of them, with commas between.
  std::string boards() const;
  // The host whose board serves, as far as the calling thread's network reaches; empty where none does.
  std::string leading_host() const;
  // The output of all hosts, for a test that failed.
  std::string said() const;

 private:
  void make_keys() const;
  void write_cell(bool with_objects) const;
  void give_objects(const std::string& folder) const;
  std::string log() const;

  const Boards boards_;
  Network network_;
  std::map<std::string, std::unique_ptr<programs::Running>> running_;
};

}  // namespace pizarra::network
