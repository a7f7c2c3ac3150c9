#pragma once

// The cameras of a cell file's (camera ...) as a StereoCamera: two devices, one that gives both images side by side,
// one camera alone, videos, image sequences, network streams, GStreamer pipelines.
//
// Devices block; so a thread reads them (camera_reading.hpp), and here its newest frame is waited for. It ends, and the
// device is let go, when nobody has asked for frames for 10 s. A camera that fails is opened again by open(). Real time
// only.
//
// A device may never answer again. So the thread is of its own, none of the executor's, which waits for its own in the
// end: whoever lets the camera go waits a second for it, and leaves it behind.
//
//   VideoCamera eyes(executor, description.eyes);
//   Result<StereoModel> model = co_await eyes.open();
//   Result<StereoFrame> frame = co_await eyes.next(executor.now(), false);
//
// Frames that cannot be read are left out, and drops() says why; of 20 in a row that is the end.
//
// Failures, each naming the camera: disconnected, refused-setting, wrong-size and those of the calibration file from
// open(); disconnected from next().

#include "drivers/camera/camera_reading.hpp"

namespace pizarra::camera {

class VideoCamera : public StereoCamera {
 public:
  using MakeSources = std::function<StereoReader::Sources()>;

  VideoCamera(Executor& executor, forms::CameraSetup setup);
  // Sources of a test's own.
  VideoCamera(Executor& executor, forms::CameraSetup setup, MakeSources make_sources);
  VideoCamera(const VideoCamera&) = delete;
  VideoCamera& operator=(const VideoCamera&) = delete;
  ~VideoCamera() override;

  Task<Result<StereoModel>> open() override;
  Task<Result<StereoFrame>> next(Time after, bool colour) override;
  CameraDrops drops() const override;

 private:
  Task<Result<void>> end_reading();
  Result<void> begin_reading();

  Executor& executor_;
  forms::CameraSetup setup_;
  MakeSources make_sources_;
  std::shared_ptr<FrameDesk> desk_;
  CameraDrops dropped_before_;
};

}  // namespace pizarra::camera
