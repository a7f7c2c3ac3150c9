#pragma once

// The words that `up` starts processes with, `agent` and `world`, and the programs that know them: pizarra-agent, and
// pizarra-eyes, which opens every camera of one's own. pizarra-agent becomes pizarra-eyes when it is asked for eyes
// whose cameras it does not open.

#include <span>

#include "agents/launcher/agent_factory.hpp"

namespace pizarra::programs {

// The real cameras that a program opens, and how.
struct OwnCameras {
  std::function<bool(const forms::CameraSetup&)> opens;
  launcher::CameraMaker make;
};

// The exit code.
int run_process_program(std::span<char*> arguments, const OwnCameras& own_cameras);

}  // namespace pizarra::programs
