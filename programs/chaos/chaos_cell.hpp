#pragma once

// A cell whose board, world and agents are processes of a simulated run, as `up` starts them: the shipped server,
// sessions and journal between them. Whoever dies is started again.
//
//   VirtualExecutor time;
//   ChaosCell cell(time, description, seed, clocks);      // or with a planted fault (plants.hpp)
//   cell.start_all();
//   cell.kill("vision", 3s);                // starts again after that
//   cell.heal();                            // all is as it should be from now on
//   cell.board();                           // for observers; null while the board does not live

#include <map>
#include <memory>
#include <string>

#include "agents/launcher/agent_factory.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/simulated/board_process.hpp"
#include "programs/chaos/device_line.hpp"
#include "programs/chaos/mistaken_eyes.hpp"

namespace pizarra::chaos {

// How far processes' clocks are apart, and how their rates differ.
struct Clocks {
  Duration apart{};
  double drift = 0;
};

class ChaosCell {
 public:
  static constexpr const char* address = "tcp://127.0.0.1:7000";

  // world_config(description, seed) has succeeded.
  ChaosCell(Executor& time, forms::CellDescription description, std::uint64_t seed, Clocks clocks,
            std::string plant = {});
  ~ChaosCell();
  ChaosCell(const ChaosCell&) = delete;
  ChaosCell& operator=(const ChaosCell&) = delete;

  Result<void> start_all();
  // As by SIGKILL, after so many more suspension points.
  void kill(const std::string& kind, Duration away, std::uint64_t after_steps = 1);
  void kill_board(Duration away, bool power, std::uint64_t after_steps);
  // As by SIGSTOP, after so many more suspension points.
  void pause(const std::string& kind, Duration length, std::uint64_t after_steps);
  // A negative number: its host is suspended for so long, and so its clock is behind by that from then on.
  void jump_clock(const std::string& kind, Duration ahead);
  // The eyes take one object for the other meanwhile.
  void exchange_names(std::string one, std::string other, Duration length);
  // The eyes tell of an object that they do not see, as soon as they do not see it.
  void invent_sighting(InventedSighting invented);
  void heal();

  Executor& time() { return time_; }
  simulated::Network& network() { return network_; }
  simulated::SimulatedDisk& disk() { return disk_; }
  WorldProcess& world() { return *world_; }
  LocalStreams& streams() { return streams_; }
  memory::MemoryBoard* board() { return board_.board(); }
  int board_lives() const { return board_.lives_begun(); }
  const forms::CellDescription& description() const { return description_; }
  // How many times an agent was started.
  int lives(const std::string& kind) const;
  // Whether it lives and is not paused.
  bool runs(const std::string& kind) const;
  std::vector<std::string> kinds() const { return launcher::agent_kinds(description_); }

  // A process that is no agent, with its session.
  struct Client {
    Client(ChaosCell& cell, const std::string& name);
    ~Client();
    simulated::Process process;
    std::unique_ptr<wire::Transport> wires;
    std::unique_ptr<client::RemoteBoard> board;
    simulated::Network& network;
    const std::string name;
  };

  simulated::Process::Clock new_clock();

 private:
  struct Agent;
  static constexpr Duration supervision = 250ms;

  Result<void> start(const std::string& kind);
  void take_down(const std::string& kind);
  void start_board();
  void supervise();
  void resume_after(Duration length, const std::string& kind);
  static void let_live(simulated::Process& process);
  simulated::Process* process_of(const std::string& kind);

  Executor& time_;
  const forms::CellDescription description_;
  const Random random_;
  Random clock_draws_;
  const Clocks clocks_;
  const std::string plant_;
  Mistakes mistakes_;
  simulated::Network network_;
  simulated::SimulatedDisk disk_;
  std::unique_ptr<WorldProcess> world_;
  LocalStreams streams_;
  simulated::BoardProcess board_;
  std::map<std::string, std::unique_ptr<Agent>> agents_;
  std::map<std::string, int> lives_;
  std::map<std::string, Time> away_until_;
  Time board_away_until_{};
  Executor::TimerId supervision_ = 0;
};

}  // namespace pizarra::chaos
