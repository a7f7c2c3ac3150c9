#pragma once

// What a bench prints: one line a figure, with its goal and what the peers took in the same run.
//
//   Figures figures("planner", Figures::Style::plain);
//   figures.say({"blocks 10, optimal", 0.021, "s", at_most(0.11 / 3, "<= a third of M"), {{"M", 0.11}}});
//   figures.must_be_none("acknowledged and lost", lost);
//   return figures.finish();      // "goals met 1 of 1"; status 0 when all figures were measured, short or not, and
//                                 // nothing was wrong
//
// A peer that is not installed has no value, `-`; a goal that needs it is `not_comparable()` and not counted.

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace pizarra::bench {

struct Goal {
  std::string text;  // "<= 1.15 x raw round trip"
  // Whether a value reaches it.
  enum class Kind { none, at_most, at_least, not_comparable } kind = Kind::none;
  double bound = 0;
};

Goal at_most(double bound, std::string text = "");
Goal at_least(double bound, std::string text = "");
// Of a figure whose peer is missing: `why` is shown.
Goal not_comparable(std::string why);

struct Peer {
  std::string name;
  std::optional<double> value;  // in the figure's unit; none: not installed, or it did not end
};

struct Figure {
  std::string name;
  std::optional<double> value;  // none: could not be measured, and the bench fails
  std::string unit;
  Goal goal;
  std::vector<Peer> peers = {};
  std::string note = "";   // what it means
  std::string limit = "";  // said where the goal is not reached: what keeps it from it
};

class Figures {
 public:
  enum class Style { plain, json };
  explicit Figures(std::string bench, Style style, std::FILE* out = stdout);

  // Prints it at once: a bench takes long.
  void say(const Figure& figure);
  // What must not be, whatever the figures: where it was found, the bench fails.
  void must_be_none(const std::string& what, int found);
  // Prints the summary and answers the exit status.
  int finish();

 private:
  const std::string bench_;
  const Style style_;
  std::FILE* const out_;
  int goals_ = 0;
  int met_ = 0;
  int unmeasured_ = 0;
  int wrong_ = 0;
};

}  // namespace pizarra::bench
