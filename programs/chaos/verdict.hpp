#pragma once

// Whether a goal ended rightly, as the world shows.
//
//   const Verdict verdict(time, judge, config, observers, player);      // all outlive it
//   const bool stands = co_await verdict.stands(goal);                  // of a goal that is said to be reached
//   verdict.on_refusal(goal, failure);                                  // of one that was refused, and why

#include <cstdint>
#include <string>
#include <vector>

#include "programs/chaos/fault_player.hpp"
#include "programs/chaos/observers.hpp"

namespace pizarra::chaos {

class Verdict {
 public:
  struct Refusal {
    // Right: no plan exists from the world's true state. Out of reach: none exists of the cubes that can be had.
    enum class Kind : std::uint8_t { right, out_of_reach, wrong };
    Kind kind = Kind::right;
    std::string wrong;  // a sentence
  };

  Verdict(Executor& time, const story::Judge& judge, simulation::WorldConfig config, const Observers& observers,
          const FaultPlayer& player);

  // While somebody interferes it is enough that the world showed it; otherwise it must stand.
  Task<bool> stands(std::vector<Datum> goal) const;
  Refusal on_refusal(const std::vector<Datum>& goal, const Failure& told) const;

 private:
  bool plan_exists(const std::vector<Datum>& goal, const story::WorldState& world) const;

  Executor& time_;
  const story::Judge& judge_;
  const simulation::WorldConfig config_;
  const Observers& observers_;
  const FaultPlayer& player_;
};

}  // namespace pizarra::chaos
