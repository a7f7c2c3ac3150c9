// Runs one agent, or the simulated world. Eyes may have JPEGs and PNGs for a camera.

#include "drivers/camera/image_files.hpp"
#include "drivers/camera/video_camera.hpp"
#include "programs/agent/agent_commands.hpp"

int main(int argc, char** argv) {
  const auto make_source = [](const pizarra::forms::CameraSource& source, const pizarra::forms::CameraSetup& setup) {
    return pizarra::camera::make_image_source(source, setup, nullptr);
  };
  const pizarra::programs::OwnCameras images{
      .opens = pizarra::camera::shows_jpegs_and_pngs_alone,
      .make = [make_source](pizarra::Executor& executor, const pizarra::forms::CameraSetup& setup) {
        return std::make_unique<pizarra::camera::VideoCamera>(executor, setup, make_source);
      }};
  return pizarra::programs::run_process_program({argv, static_cast<std::size_t>(argc)}, images);
}
