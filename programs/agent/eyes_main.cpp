// Runs one agent, with whatever camera of one's own the cell has.

#include "programs/agent/agent_commands.hpp"
#include "drivers/camera/any_source.hpp"
#include "drivers/camera/video_camera.hpp"

int main(int argc, char** argv) {
  const pizarra::OwnCameras every{.opens = [](const pizarra::CameraSetup&) { return true; },
                                  .make =
                                      [](pizarra::Executor& executor, const pizarra::CameraSetup& setup) {
                                        return std::make_unique<pizarra::VideoCamera>(executor, setup,
                                                                                      pizarra::make_any_source);
                                      }};
  return pizarra::run_process_program({argv, static_cast<std::size_t>(argc)}, every);
}
