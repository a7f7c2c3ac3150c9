#pragma once

// The simulated cell's stereo pair as a StereoCamera: 10 frames a second, taken only when asked for.
//
//   SimulatedCamera eyes(link);
//   Result<StereoModel> model = co_await eyes.open();
//   Result<StereoFrame> frame = co_await eyes.next(0, false);

#include "drivers/camera/stereo_camera.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra {

class SimulatedCamera : public StereoCamera {
 public:
  // The link outlives it.
  explicit SimulatedCamera(Link& link) : link_(link) {}
  Task<Result<StereoModel>> open() override;
  Task<Result<StereoFrame>> next(std::uint64_t after, bool colour) override;

 private:
  Link& link_;
};

}  // namespace pizarra
