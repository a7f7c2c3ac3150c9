#pragma once

// The word `plan`: a plan for a domain and a problem file, on standard output.

#include <CLI/CLI.hpp>

namespace pizarra::programs {

void add_plan_command(CLI::App& app, int& status);

}  // namespace pizarra::programs
