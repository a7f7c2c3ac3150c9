#pragma once

// The board that is shipped, as a process of a simulated run: journal, board and server on a simulated disk and
// network. It may be killed at any time, and lives again from its journal.
//
//   BoardProcess board(time, network, disk, Random(seed), "tcp://127.0.0.1:7000");
//   Result<void> lives = board.start({});          // fails as pizarra-board does, where the journal cannot be opened
//   board.board();                                 // what stands on it; null while it does not live
//   board.kill();                                  // as by SIGKILL
//   board.cut_power();                             // the same, and what the disk had not flushed is in doubt

#include <memory>
#include <string>

#include "blackboard/server/board_server.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/simulated/network.hpp"
#include "blackboard/simulated/process.hpp"
#include "blackboard/simulated/simulated_disk.hpp"

namespace pizarra::simulated {

class BoardProcess {
 public:
  static constexpr const char* name = "board";

  // All outlive it.
  BoardProcess(Executor& time, Network& network, SimulatedDisk& disk, Random random, std::string address);
  BoardProcess(const BoardProcess&) = delete;
  BoardProcess& operator=(const BoardProcess&) = delete;
  ~BoardProcess();

  // Not while it lives.
  Result<void> start(Process::Clock clock);
  void kill();
  void cut_power();
  bool lives() const { return life_ != nullptr; }
  Process* process() const;
  memory::MemoryBoard* board();
  const std::string& address() const { return address_; }
  int lives_begun() const { return lives_; }

 private:
  struct Life;
  Result<void> begin(Life& life);

  Executor& time_;
  Network& network_;
  SimulatedDisk& disk_;
  Random random_;
  const std::string address_;
  int lives_ = 0;
  std::unique_ptr<Life> life_;
};

}  // namespace pizarra::simulated
