#pragma once

// The pan-tilt agent: it turns a stereo head through a PanTiltDriver and offers the thesis' 11 operations in degrees
// and percent, absolute and relative, within the limits of the unit that is there; and `look-at`, which keeps an object
// in view (docs/facts/pan-tilt.md). Positions answer once the unit has accepted them; the `head` fact tells the rest.
//
//   PanTiltAgent agent(context, driver, mount);
//   Job job = executor.spawn(agent.run());
//
// A unit that is away, or loses its power, is looked for until it is back; meanwhile requests fail with `disconnected`
// and no `head` fact stands, because nobody knows where it looks. What moves the unit ends `look-at`.
//
// Failures: closed, disconnected, out-of-range, unknown-place, and the driver's.

#include "agents/runtime/agent.hpp"
#include "drivers/ptu/pan_tilt_driver.hpp"
#include "lisp/forms/camera_pose.hpp"

namespace pizarra::pan_tilt {

class PanTiltAgent : public runtime::Agent {
 public:
  // The driver outlives it. `mount`: how the camera looks while the head is in its middle.
  PanTiltAgent(runtime::AgentContext context, ptu::PanTiltDriver& driver, forms::CameraPose mount);
  ~PanTiltAgent() override;
  Task<Result<void>> run() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pizarra::pan_tilt
