#pragma once

// Scenario files: a story that happens in a cell, and how it must end.
//
//   (scenario "a block is moved during the approach"
//     (cell "../../examples/01-blocks/cell.scm")               ; relative to the scenario file
//     (cubes (cube circle (at 450 -150)) (cube square (at 450 50)))   ; instead of the cell's
//     (goal (on circle triangle) (on triangle square))
//     (before-goal (hand remove cross))                        ; done when everything has been learned
//     (when (servo 3 circle ? ? ?) (hand push circle 0 40))
//     (when (and (on circle triangle) (on triangle square)) (wait 1) (hand knock circle))
//     (expect reached)                                         ; or (expect refused SYMBOL)
//     (expect-seen (event ? difference ? ?))                   ; must hold at some time
//     (expect-not (operation ? (PICK-UP cross) ?))             ; must never hold
//     (within 180))                                            ; seconds of the cell's time after the goal
//
// The `when`s happen in their order: each waits for the one before it. A condition is a query (blackboard/query.hpp),
// and its variables stand for their values in the actions.
//
// Actions of the world: (hand OPERATION ARGUMENT ...), (fingers slip), (fingers slips CHANCE DRAWS SECONDS),
// (fingers misplace PART), (camera bump DX DY DZ DPAN DTILT DROLL), (head nudge DPAN DTILT).
//
// Actions of the cell: (kill AGENT), (restart AGENT), (restart AGENT "HOST"), (wire CLIENT ROLE AGENT), (wait SECONDS),
// (goal FACT ...).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lisp/forms/cell_file.hpp"

namespace pizarra::forms {

struct ScenarioEvent {
  Datum condition;
  std::vector<Datum> actions;
};

struct Scenario {
  std::string file;  // where it was read from; empty: it was not
  std::string name;
  std::string cell_file;                            // a path that can be opened
  std::string domain_file;                          // empty: the cell's
  std::optional<std::vector<CubePlacement>> cubes;  // empty: the cell's
  std::vector<Datum> goal;
  std::vector<Datum> before_goal;
  std::vector<ScenarioEvent> events;
  bool expect_reached = true;
  std::string refusal;  // where refused is expected: its symbol, empty: any
  std::vector<Datum> expect_seen;
  std::vector<Datum> expect_never;
  double within_s = 180;
  std::uint64_t seed = 1;
};

Result<Scenario> read_scenario(std::string_view text, const std::string& file);
Result<Scenario> read_scenario_file(const std::string& path);

}  // namespace pizarra::forms
