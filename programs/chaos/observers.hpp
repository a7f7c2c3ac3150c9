#pragma once

// Observers look at a running cell from outside and report what must never happen. No agent knows of them. They see
// each request that reaches the arm's controller (arm_observer.hpp), the facts on the board, and the world itself.
//
//   Observers observers(cell, judge, tell, is_quiet);
//   observers.begin();
//   observers.acknowledged(7);                  // the board said that it keeps (chaos-mark 7)
//   observers.unsafe();                         // a sentence each
//
// Looked for here: a goal said to be reached that the world does not show. Of motions: arm_observer.hpp. Of what is
// believed: belief_observer.hpp. Of what the board must keep: kept_observer.hpp.

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "programs/chaos/arm_observer.hpp"
#include "programs/chaos/belief_observer.hpp"
#include "programs/chaos/chaos_cell.hpp"
#include "programs/chaos/coverage.hpp"
#include "programs/chaos/kept_observer.hpp"
#include "programs/chaos/present_agents.hpp"
#include "programs/chaos/world_news.hpp"
#include "programs/story/judge.hpp"

namespace pizarra::chaos {

class Observers {
 public:
  using Tell = std::function<void(Time when, const std::string& kind, const std::string& sentence)>;

  // All outlive it. `is_quiet`: a goal was given, and no fault is under way.
  Observers(ChaosCell& cell, const story::Judge& judge, Tell tell, std::function<bool()> is_quiet);
  Observers(const Observers&) = delete;
  Observers& operator=(const Observers&) = delete;

  void begin();
  void acknowledged(std::int64_t mark) { kept_.acknowledged(mark); }
  // Whether the world showed these facts at some time lately.
  bool showed_lately(const std::vector<Datum>& goal) const;
  // Compares the facts on the board with those that were acknowledged.
  void check_marks() const { kept_.check_marks(); }
  void add_unsafe(std::string sentence);
  const std::vector<std::string>& unsafe() const { return unsafe_; }
  const Coverage& coverage() const { return coverage_; }
  // The facts that are true in the world now, and how each cube lies.
  const story::WorldState& world() const { return newest_; }

 private:
  struct Moment {
    Time when;
    std::vector<Datum> facts;
  };
  Task<void> look();
  Task<void> look_at_world();
  void look_at_board();
  void note_event(const Datum& event);
  void look_at_presence();
  void look_at_beliefs(double opening_mm);
  bool are_all_present() const;

  ChaosCell& cell_;
  const story::Judge& judge_;
  const Tell tell_;
  const std::function<bool()> is_quiet_;
  Coverage coverage_;
  std::vector<std::string> unsafe_;
  std::deque<Moment> lately_;
  story::WorldState newest_;
  WorldNews world_news_;
  std::int64_t last_event_ = 0;
  int board_lives_ = 1;
  PresentAgents present_;
  std::string arm_action_;
  std::vector<Datum> looks_;  // the newest
  Time looked_{};             // when it came
  KeptObserver kept_;
  ArmObserver arm_;
  BeliefObserver beliefs_;
  Job looking_;
};

}  // namespace pizarra::chaos
