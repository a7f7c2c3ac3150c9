#pragma once

// Looks from outside at each request that reaches the arm's controller, and tells of motions that must never be:
//
//   - one that begins while a stop has stood, or another client commanded the arm, for longer than it takes to hear
//   - one that the board does not know of, or that is made again for a request of an earlier life of the robot agent
//   - one of the arm that goes on after a stop came to its controller and the brakes had their time
//   - one of the fingers that goes on after that, though they can be told to stand
//
//   ArmObserver observer(cell, [&](std::string sentence) { ... });
//   observer.begin();

#include <functional>
#include <map>
#include <optional>
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
  void note_motion();
  void note_grip(double opening_mm);
  bool stands(const std::optional<Standing>& standing) const;
  Task<Reading> read();
  Task<void> check_grip(double opening_mm);
  Task<void> check_halt();
  Task<void> check_fingers();
  Task<void> watch();
  bool is_impaired() const;
  void look_at_board();
  void note(std::optional<Standing>& standing, const Datum& fact) const;

  ChaosCell& cell_;
  const Unsafe unsafe_;
  std::uint64_t motions_ = 0;       // of the arm that began
  std::uint64_t grips_ = 0;         // and of the fingers
  std::map<Datum, int> moved_for_;  // a request, and the life of the robot agent that moved for it
  std::optional<Standing> stop_;
  std::optional<Standing> commander_;
  bool of_fingers_ = false;  // the newest motion
  Time impaired_{};          // the agent was last, or its line to the controller
  std::vector<Job> checks_;
  Job watching_;
};

}  // namespace pizarra::chaos
