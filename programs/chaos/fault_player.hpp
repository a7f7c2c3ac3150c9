#pragma once

// Lets the faults of a run happen, each at its time, and ends them all.
//
//   FaultPlayer player(cell, bystander, caller, faults, tell);
//   player.begin();                       // the fault phase
//   player.end();                         // the quiet phase: all is well again, and nobody interferes

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agents/runtime/caller.hpp"
#include "programs/chaos/chaos_cell.hpp"
#include "programs/chaos/coverage.hpp"
#include "programs/chaos/fault.hpp"
#include "programs/chaos/peek.hpp"

namespace pizarra::chaos {

class FaultPlayer {
 public:
  // `tell` hears of each fault as it happens. The cell, `bystander`, with whose session people stop the cell or command
  // its arm, and `caller`, with which they reset an alarm, outlive it.
  FaultPlayer(ChaosCell& cell, ChaosCell::Client& bystander, runtime::Caller& caller, std::vector<Fault> faults,
              std::function<void(const std::string&)> tell);
  ~FaultPlayer();
  FaultPlayer(const FaultPlayer&) = delete;
  FaultPlayer& operator=(const FaultPlayer&) = delete;

  void begin();
  // What was begun by a hand is ended: it does not leave what it carries in the air. Done when nothing is under way.
  Task<void> end();
  const Coverage& coverage() const { return coverage_; }
  std::size_t happened() const { return happened_; }
  // When a hand last moved something.
  Time hand_moved() const { return hand_moved_; }
  bool hand_is_busy() const { return hands_ > 0; }
  // Whether no fault is under way. A bump is, and a wrong guess of where the camera stands, until the cell has measured
  // that. A silent line is, until the arm has answered again.
  bool is_quiet() const;

 private:
  // Whether the robot agent has had an answer since the arm's line was silent last.
  bool arm_answers() const;
  bool camera_is_sought() const;
  Task<void> happen_in_time(const Fault& fault);
  Task<void> await_servo(const Fault::When& when);
  void happen(const Fault& fault);
  void count(const std::string& kind, const InHand& during);
  void do_to_network(const Datum& what);
  void do_to_disk(const Datum& what);
  void do_to_camera(const Datum& what);
  void bump_camera(const Datum& what);
  void do_to_arm(const Datum& what);
  void request_from_world(Datum device, const Datum& what);
  Task<void> move_hand(Datum request);
  Task<void> borrow(Datum what);
  // The bystander says a fact, and takes it back.
  Task<void> say(Datum fact, Duration length);
  Task<void> alarm_for(Duration length);
  Task<void> let_slip();
  Task<void> ask_world(Datum request);

  ChaosCell& cell_;
  ChaosCell::Client& bystander_;
  runtime::Caller& caller_;
  const std::vector<Fault> faults_;
  const std::function<void(const std::string&)> tell_;
  forms::CameraPose camera_;
  std::optional<Time> camera_sought_since_;  // it stands elsewhere than the agents take it to
  Datum told_before_;                        // of the camera
  Coverage coverage_;
  std::size_t happened_ = 0;
  int hands_ = 0;
  int said_ = 0;
  int alarms_ = 0;
  Time hand_moved_{};
  Time disturbed_until_{};
  bool ending_ = false;
  std::vector<Job> waiting_;
  std::vector<Job> acting_;
};

}  // namespace pizarra::chaos
