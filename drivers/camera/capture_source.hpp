#pragma once

// The sources that OpenCV's VideoCapture opens: devices, network streams, GStreamer pipelines.
//
// Lifecycle: open(), then grab() and retrieve() for each image; close(), after which it may be opened again.
//
//   CaptureSource source({forms::CameraSource::Kind::device, "/dev/video0"}, setup);
//   if (source.open() && source.grab()) show(*source.retrieve(true));

#include <opencv2/videoio.hpp>

#include "drivers/camera/frame_source.hpp"

namespace pizarra::camera {

class CaptureSource : public FrameSource {
 public:
  CaptureSource(forms::CameraSource source, const forms::CameraSetup& setup)
      : source_(std::move(source)), setup_(setup) {}

  Result<void> open() override;
  void close() override {
    if (capture_) capture_->release();
  }
  Result<std::optional<double>> grab() override;
  Result<cv::Mat> retrieve(bool grey) override;
  double recorded_hz() const override { return 0; }

 private:
  bool open_capture();
  Result<void> apply_settings();

  forms::CameraSource source_;
  forms::CameraSetup setup_;
  std::unique_ptr<cv::VideoCapture> capture_;  // none before it is first opened
};

}  // namespace pizarra::camera
