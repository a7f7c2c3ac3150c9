#pragma once

// A run drawn from its seed: the cell, the goals in a row, and what goes wrong in the fault phase. Each run has a
// subset of the classes of faults, so that faults that hide each other meet alone too.
//
//   Result<ChaosStory> story = draw_story(cell, 620063, {});           // of all classes
//   for (const std::string& line : describe(*story)) ...

#include <string>
#include <vector>

#include "lisp/forms/cell_file.hpp"
#include "programs/chaos/chaos_cell.hpp"
#include "programs/chaos/fault.hpp"

namespace pizarra::chaos {

struct ChaosStory {
  std::uint64_t seed = 0;
  forms::CellDescription cell;
  std::vector<std::vector<Datum>> goals;  // facts, one goal after another
  double fault_phase_s = 0;
  Clocks clocks;
  std::vector<std::string> classes;
  std::vector<Fault> faults;  // by class, in the order in which they were drawn
};

// Of these classes alone; none named: of all. The cell passed story::check_random_cell().
ChaosStory draw_story(const forms::CellDescription& cell, std::uint64_t seed, const std::vector<std::string>& only);

// In which ways the cell is not a plain one, a word each: many-cubes, tags, bodies, head.
std::vector<std::string> special_about(const forms::CellDescription& cell);

// Every option drawn, a line each.
std::vector<std::string> describe(const ChaosStory& story);

}  // namespace pizarra::chaos
