#pragma once

// The word `scheme`: runs a Scheme file as an agent, or tries it on a story without a cell.

#include <CLI/CLI.hpp>

namespace pizarra::programs {

void add_scheme_command(CLI::App& app, int& status);

}  // namespace pizarra::programs
