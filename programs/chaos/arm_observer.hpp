#pragma once

// Looks from outside at each request that reaches the arm's controller, and tells of motions that must never be.
//
// A motion may not begin under a stop, nor while another client commands the arm, and the motion under way ends when
// another client begins to; the robot agent has 100 ms to hear of either. The board must know of each motion. For one
// request the arm moves once, whichever life of the robot agent moves it, and the fingers do. A stop that comes to the
// controller is heeded at once: the arm rests when its brakes have taken it from the motion's speed to rest, and the
// fingers when they are told to stay where they are. Where a controller has a silence limit and hears nothing for
// so long, the motion ends in the same way.
//
//   ArmObserver observer(cell, [&](std::string sentence) { ... });
//   observer.begin();

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "programs/chaos/chaos_cell.hpp"

namespace pizarra::chaos {

class ArmObserver {
 public:
  using Unsafe = std::function<void(std::string sentence)>;

  // The cell outlives it.
  ArmObserver(ChaosCell& cell, Unsafe unsafe);
  ~ArmObserver();
  ArmObserver(const ArmObserver&) = delete;
  ArmObserver& operator=(const ArmObserver&) = delete;

  void begin();

 private:
  struct Standing {
    Datum fact;
    Time since{};
  };
  struct Reading {
    bool moves = false;
    bool was_stopped = false;
    double opening_mm = 0;
    bool fingers_move = false;
  };

  void hear(const Datum& request);
  void note_begun(const Datum& motion);
  void note_motion();
  void note_grip(double opening_mm);
  // For which request on the board it is done.
  void note_order(const Datum& request);
  bool stands(const std::optional<Standing>& standing) const;
  Task<Reading> read();
  Task<void> check_grip(double opening_mm);
  Task<void> check_halt();
  void look_at_silence();
  Task<void> check_silence();
  Task<void> check_handover();
  Task<void> check_fingers();
  Task<void> watch();
  Duration brakes_take() const;
  bool is_impaired() const;
  std::optional<Datum> request_in_hand() const;
  std::string client_in_hand() const;
  void look_at_board();
  void note(std::optional<Standing>& standing, const Datum& fact) const;

  ChaosCell& cell_;
  const Unsafe unsafe_;
  std::uint64_t arm_motions_ = 0;  // that began
  std::uint64_t finger_motions_ = 0;
  bool fingers_began_last_ = false;
  double speed_ = 1;           // of the newest motion of the arm, of its full speed
  Time stop_came_{};           // to the controller, last
  Time heard_{};               // the controller anything, last
  Time silent_since_{};        // at the newest silence that was looked at
  std::set<Datum> moved_for_;  // requests
  std::optional<Standing> stop_;
  std::optional<Standing> commander_;
  Time last_impaired_{};  // when the robot agent, or its line to the controller, failed last
  std::vector<Job> checks_;
  Job watching_;
};

}  // namespace pizarra::chaos
