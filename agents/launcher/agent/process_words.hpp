#pragma once

// The words that `up` starts processes with, `agent` and `world`, and the programs that know them: pizarra-agent, and
// pizarra-eyes, which opens cameras of one's own too. Who is asked for such eyes and has no `own_cameras` becomes
// pizarra-eyes.

#include <span>

#include "agents/launcher/supervision/agent_factory.hpp"

namespace pizarra {

// The exit code.
int run_process_program(std::span<char*> arguments, CameraMaker own_cameras);

}  // namespace pizarra
