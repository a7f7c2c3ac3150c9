#pragma once

// Compares what the coordinator believes with the world: the place of each object whose mark is in sight, and the
// domain's facts. No agent knows of it.
//
//   BeliefObserver observer(camera_at_mm, judge, [&](std::string sentence) { ... });
//   observer.look({.now = now, .quiet = true, .world = &world, .opening_mm = 100,
//                  .told = told_on(board)});                     // some times a second
//
// A difference is unsafe once it has lasted for a second of quiet. Nothing fails then, and nobody interferes. The
// object lies still in plain sight: both cameras see its whole mark, on a face that is turned to them by 35 degrees or
// less and is not cut off by an image's border. The eyes recognise marks up to that angle (docs/eyes.md). Facts are
// compared while all cubes lie so.

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "blackboard/memory/memory_board.hpp"
#include "programs/story/judge.hpp"

namespace pizarra::chaos {

// What the coordinator tells, by names in small letters.
struct ToldBeliefs {
  std::map<std::string, Eigen::Vector3d> places;  // of marks
  std::set<Datum> facts;
};
// Nothing where the board does not live.
ToldBeliefs told_on(const memory::MemoryBoard* board);

class BeliefObserver {
 public:
  using Unsafe = std::function<void(std::string sentence)>;
  struct Moment {
    Time now;
    bool quiet = false;
    const story::WorldState* world = nullptr;
    double opening_mm = 0;  // of the fingers, truly
    ToldBeliefs told;
  };

  // The judge outlives it.
  BeliefObserver(const Eigen::Vector3d& camera_mm, const story::Judge& judge, Unsafe unsafe)
      : camera_mm_(camera_mm), judge_(judge), unsafe_(std::move(unsafe)) {}

  void look(const Moment& moment);

 private:
  struct Lying {
    Eigen::Vector3d at_mm;
    Time since;  // it lies there, in plain sight
  };
  using Wrong = std::map<std::string, std::string>;  // what, and a sentence that says how

  void note_lying(const Moment& moment);
  bool is_steady(const std::string& name, Time now) const;
  double off_mm(const std::string& name, const story::WorldState::Cube& cube, const Eigen::Vector3d& place_mm) const;
  Wrong wrong_places(const Moment& moment) const;
  bool all_in_sight(const Moment& moment) const;
  bool may_hold(const Moment& moment) const;
  Wrong wrong_facts(const Moment& moment) const;
  story::WorldState as_told(const Moment& moment) const;

  const Eigen::Vector3d camera_mm_;
  const story::Judge& judge_;
  const Unsafe unsafe_;
  std::map<std::string, Lying> lying_;
  std::map<std::string, Time> wrong_since_;
  std::set<std::string> said_;
};

}  // namespace pizarra::chaos
