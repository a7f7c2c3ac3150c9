#pragma once

// Which of a cell's hosts this machine is.
//
//   Result<CellHost> host = choose_host(cell, "");

#include "lisp/forms/cell_file.hpp"

namespace pizarra::host {

// The host asked for, this machine if the file names it, "localhost", or the only one. Failure: unknown-host.
Result<forms::CellHost> choose_host(const forms::CellDescription& cell, const std::string& asked);

}  // namespace pizarra::host
