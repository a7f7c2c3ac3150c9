#pragma once

// The simulated cell's stereo pair as a StereoCamera. Frames are taken only when asked for; those of lenses that bend
// are straightened by what the cameras say of themselves, as a calibrated pair's are. A frame that the line gives once
// more is not a new one: the next is asked for.
//
//   SimulatedCamera eyes(executor, link);
//   Result<StereoModel> model = co_await eyes.open();
//   Result<StereoFrame> frame = co_await eyes.next(executor.now(), false);

#include <optional>

#include "blackboard/time/executor.hpp"
#include "drivers/camera/stereo_camera.hpp"
#include "drivers/camera/stereo_geometry.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class SimulatedCamera : public camera::StereoCamera {
 public:
  // Both outlive it.
  SimulatedCamera(Executor& executor, Link& link) : executor_(executor), link_(link) {}
  Task<Result<camera::StereoModel>> open() override;
  Task<Result<camera::StereoFrame>> next(Time after, bool colour) override;

 private:
  Task<Result<camera::StereoFrame>> ask(Time after, bool colour);

  Executor& executor_;
  Link& link_;
  std::optional<camera::StereoGeometry> geometry_;  // of lenses that bend
  // The numbers of the newest frames since it was opened.
  std::uint64_t last_grey_ = 0;
  std::uint64_t last_coloured_ = 0;
};

}  // namespace pizarra::simulation
