#pragma once

// The thread that reads a camera: it opens the camera and takes moment after moment. Of each it makes a rectified grey
// pair (and a coloured one while somebody asks), and leaves it on the desk, until the desk closes or the camera is
// gone.
//
//   read_camera({.setup = setup, .sources = make, .now = now}, desk);

#include "drivers/camera/calibration.hpp"
#include "drivers/camera/frame_desk.hpp"
#include "drivers/camera/stereo_reader.hpp"

namespace pizarra::camera {

struct CameraReading {
  forms::CameraSetup setup;
  std::optional<StereoCalibration> calibration;  // what the setup's file says: files are interpreted on one thread
  std::function<StereoReader::Sources()> sources;
  std::function<Time()> now;
};

// Blocks. A frame that cannot be read is left out, 20 in a row are the end. Afterwards the sources are closed, and the
// desk says why no frame will come any more.
void read_camera(const CameraReading& reading, FrameDesk& desk);

}  // namespace pizarra::camera
