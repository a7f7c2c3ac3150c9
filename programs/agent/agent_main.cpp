// Runs one agent, or the simulated world. Eyes may have JPEGs and PNGs for a camera.

#include "programs/agent/agent_commands.hpp"
#include "drivers/camera/image_files.hpp"
#include "drivers/camera/video_camera.hpp"

int main(int argc, char** argv) {
  const auto make_source = [](const pizarra::CameraSource& source, const pizarra::CameraSetup& setup) {
    return pizarra::make_image_source(source, setup, nullptr);
  };
  const pizarra::OwnCameras images{
      .opens = pizarra::shows_jpegs_and_pngs_alone,
      .make = [make_source](pizarra::Executor& executor, const pizarra::CameraSetup& setup) {
        return std::make_unique<pizarra::VideoCamera>(executor, setup, make_source);
      }};
  return pizarra::run_process_program({argv, static_cast<std::size_t>(argc)}, images);
}
