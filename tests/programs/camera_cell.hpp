#pragma once

// Cells with a camera of one's own, and what pizarra says of them.
//
//   const Said said = run_cell("check " + cell_with("alone", "(single (device 0))"));

#include <fstream>
#include <string>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {

inline Said run_cell(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

// The file of a cell of that name.
inline std::string cell_with(const std::string& name, const std::string& camera) {
  std::string file = scratch_folder() + name + ".scm";
  std::ofstream(file) << "(cell " << name << " (camera " << camera << ") (host \"localhost\" (agents vision)))";
  return file;
}

}  // namespace pizarra::programs
