#pragma once

// The cell of examples/01-blocks, whose eyes know its objects from the start, in a folder of this test's own: what
// tests/taught_cell writes. For tests in real time that need the objects and not how they are taught.
//
//   Running up({PIZARRA_CELL, "up", taught_cell(PIZARRA_CELL) + "cell.scm"}, scratch_folder() + "up.log");

#include <string>

namespace pizarra::programs {

// The folder, with a slash at its end; it holds cell.scm and objects/. Throws where the objects cannot be taught.
std::string taught_cell(const std::string& program);

}  // namespace pizarra::programs
