#pragma once

// How long it takes to have a cube that slipped between the fingers again, by what the cell itself tells: its fingers
// close on nothing, the coordinator notices, decides, and grips.
//
//   RetryWatch watch;
//   watch.take(fact, now_s);              // (gripper ...), (micro-task ...) and (event ...), as they come
//   watch.retries();

#include <array>
#include <optional>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::bench {

// Each from the end of the part before, the first from the slip.
struct Retry {
  static constexpr std::size_t parts = 4;
  static constexpr std::array<const char*, parts> names{"noticed", "decided", "at the cube", "gripped"};
  std::array<double, parts> part_s;
};

class RetryWatch {
 public:
  void take(const Datum& fact, double now_s);
  // Of each slip after which something was gripped.
  const std::vector<Retry>& retries() const { return retries_; }

 private:
  void take_opening(double opening_mm, double now_s);
  void take_step(const Datum& step, std::string_view state, double now_s);
  void pass(std::size_t part, double now_s);

  double opening_mm_ = 0;
  std::optional<double> held_mm_;  // the opening, while something is between the fingers
  std::vector<double> reached_s_;  // the ends of the parts, and before them the slip
  std::vector<Retry> retries_;
};

}  // namespace pizarra::bench
