#pragma once

// A camera that gives what its test says, on the reader's thread: images of one level, at given moments or as they
// come, with faults.

#include <atomic>
#include <fmt/format.h>

#include "drivers/camera/frame_source.hpp"

namespace pizarra::camera {

// Shared by a test and the sources it makes.
struct FakeDevice {
  std::atomic<bool> plugged = true;
  std::atomic<bool> garbage = false;
  std::atomic<int> garbage_left = 0;  // of the next images so many are garbage
  std::atomic<bool> hangs = false;
  std::atomic<int> width = 320;
  std::atomic<int> height = 240;
  std::atomic<int> opened = 0;
  std::atomic<int> open_now = 0;
  std::atomic<int> retrieved = 0;
  std::vector<double> moments_ms;  // one an image; empty: as they come
  std::atomic<bool> recorded = false;
  double hz = 0;  // of a recording
};

class FakeSource : public FrameSource {
 public:
  explicit FakeSource(FakeDevice& device) : device_(device) {}
  ~FakeSource() override { close(); }

  Result<void> open() override {
    close();
    if (!device_.plugged) return fail("disconnected", "fake cannot be opened");
    ++device_.opened;
    ++device_.open_now;
    open_ = true;
    taken_ = 0;
    return {};
  }
  void close() override {
    if (open_) --device_.open_now;
    open_ = false;
  }
  Result<std::optional<double>> grab() override {
    device_.hangs.wait(true);
    if (!device_.plugged) return fail("disconnected", "fake gives no images");
    const std::size_t image = taken_++;
    if (device_.moments_ms.empty()) return std::nullopt;
    if (image >= device_.moments_ms.size()) return fail("ended", "fake is over");
    return device_.moments_ms[image];
  }
  Result<cv::Mat> retrieve(bool /*grey*/) override {
    ++device_.retrieved;
    const bool garbled = device_.garbage || device_.garbage_left > 0;
    if (device_.garbage_left > 0) --device_.garbage_left;
    if (garbled) return fail("corrupt-frame", "what fake gives is no image that can be read");
    return cv::Mat(device_.height, device_.width, CV_8UC3, cv::Scalar::all(static_cast<double>(taken_)));
  }
  double recorded_hz() const override { return device_.hz; }

 private:
  FakeDevice& device_;
  bool open_ = false;
  std::size_t taken_ = 0;
};

}  // namespace pizarra::camera
