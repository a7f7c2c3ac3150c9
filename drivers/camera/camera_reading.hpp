#pragma once

// What the thread that reads a camera does: opens it, takes moment after moment, makes a rectified grey pair of each
// (and a coloured one while somebody asks), and leaves it on the desk, until the desk closes or the camera is gone.
//
//   read_camera({.setup = setup, .sources = make, .now = now, .first_number = 1}, desk);

#include "drivers/camera/calibration.hpp"
#include "drivers/camera/frame_desk.hpp"
#include "drivers/camera/stereo_reader.hpp"

namespace pizarra {

struct CameraReading {
  CameraSetup setup;
  std::optional<StereoCalibration> calibration;  // what the setup's file says: files are interpreted on one thread
  std::function<StereoReader::Sources()> sources;
  std::function<Time()> now;
  std::uint64_t first_number = 1;
};

// Blocks. Afterwards the sources are closed, and the desk says why no frame will come any more.
void read_camera(const CameraReading& reading, FrameDesk& desk);

}  // namespace pizarra
