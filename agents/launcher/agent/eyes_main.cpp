// Runs one agent, with cameras of one's own where the cell has such.

#include "agents/launcher/agent/process_words.hpp"
#include "drivers/camera/video_camera.hpp"

int main(int argc, char** argv) {
  const auto open = [](pizarra::Executor& executor, const pizarra::CameraSetup& setup) {
    return std::make_unique<pizarra::VideoCamera>(executor, setup);
  };
  return pizarra::run_process_program({argv, static_cast<std::size_t>(argc)}, open);
}
