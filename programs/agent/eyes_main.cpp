// Runs one agent, with whatever camera of one's own the cell has.

#include "drivers/camera/any_source.hpp"
#include "drivers/camera/video_camera.hpp"
#include "programs/agent/agent_commands.hpp"

int main(int argc, char** argv) {
  const pizarra::programs::OwnCameras every{
      .opens = [](const pizarra::forms::CameraSetup&) { return true; },
      .make =
          [](pizarra::Executor& executor, const pizarra::forms::CameraSetup& setup) {
            return std::make_unique<pizarra::camera::VideoCamera>(executor, setup, pizarra::camera::make_any_source);
          }};
  return pizarra::programs::run_process_program({argv, static_cast<std::size_t>(argc)}, every);
}
