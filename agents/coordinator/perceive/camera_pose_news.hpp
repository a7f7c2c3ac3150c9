#pragma once

// Tells where the camera is taken to stand, as the durable fact (camera-pose X Y Z PAN TILT ROLL STATE SPREAD GUESS)
// and in the story, whenever that changes; and reads it back after a restart.
//
//   const std::optional<CameraMeasured> measured = co_await news.told_before();
//   co_await news.tell(scene.camera(), what_a_look_told);

#include "agents/coordinator/geometry/camera_watch.hpp"
#include "agents/coordinator/story.hpp"
#include "agents/runtime/agent.hpp"

namespace pizarra::coordinator {

class CameraPoseNews {
 public:
  // `guess`: the cell file's. A pose that was measured under another guess does not count.
  CameraPoseNews(runtime::AgentContext& context, const forms::CameraPose& guess, Story& story)
      : context_(context), guess_(guess), story_(story) {}

  Task<std::optional<CameraMeasured>> told_before();
  Task<void> tell(const CameraWatch& camera, CameraWatch::News news);

 private:
  runtime::AgentContext& context_;
  const forms::CameraPose guess_;
  Story& story_;
  std::string told_;  // the state; empty before the first look
};

}  // namespace pizarra::coordinator
