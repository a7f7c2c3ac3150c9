#pragma once

// Reads one or two sources so that every pair is of one moment: all are grabbed before any is decoded, and of two that
// lie too far apart in time the older one is let go. A recording that is over begins anew.
//
//   StereoReader reader(setup, std::move(sources), now);
//   Result<void> opened = reader.open();
//   Result<void> grabbed = reader.grab();
//   Result<StereoImages> pair = reader.retrieve(grey);     // or grab() again, where this moment is not wanted
//
// Failures name the camera: those of the sources, and corrupt-frame where a pair does not fit together.

#include <functional>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "drivers/camera/frame_source.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::camera {

// As they come: grey or BGR; of one camera alone the left one only.
struct StereoImages {
  cv::Mat left;
  cv::Mat right;
  Time captured{};
};

class StereoReader {
 public:
  using Sources = std::vector<std::unique_ptr<FrameSource>>;

  // `sources` as many as `setup.sources`; `now` is called on the reader's thread.
  StereoReader(const forms::CameraSetup& setup, Sources sources, std::function<Time()> now);

  // A recording that is over shall not begin anew: grab() then fails with `ended`.
  void read_once() { once_ = true; }
  Result<void> open();
  void close();
  Result<void> grab();
  // As FrameSource::retrieve().
  Result<StereoImages> retrieve(bool grey);
  double recorded_hz() const { return sources_.front()->recorded_hz(); }
  // Images let go because no partner of their moment came.
  std::uint64_t skewed() const { return skewed_; }

 private:
  std::string camera(std::size_t source) const;
  Failure named(std::size_t source, const Failure& failure) const;
  Result<void> grab_all();
  Result<double> grab_one(std::size_t source);
  Result<void> fit_moments();
  Result<void> check_size(const StereoImages& images) const;

  forms::CameraSetup setup_;
  Sources sources_;
  std::function<Time()> now_;
  std::vector<double> moments_ms_;
  Time captured_{};
  bool once_ = false;
  bool taken_any_ = false;
  std::uint64_t skewed_ = 0;
};

}  // namespace pizarra::camera
