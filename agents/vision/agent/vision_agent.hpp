#pragma once

// The vision agent: learns, finds and tracks marks in the images of a stereo camera, and nothing else than these images
// is known to it. Its replies are the thesis' Table C.2 to the letter; facts as docs/facts/vision.md lists them.
//
// Lifecycle: constructed, run() spawned; `(connect)` opens the capture and starts the data channel, `learn`, `find` and
// `track` open it themselves (`track` connects too, for its only output is that channel). Learned objects are kept
// (object_memory.hpp), so that a restarted agent knows them. It does not resume tracking. A camera that fails is tried
// again with back-off and the fact `(camera-state ...)` says so.
//
// Modes: idle, capturing, learning, finding, tracking. Learning and tracking exclude each other; a find suspends a
// tracking and resumes it, and disturbs no learning. Each client connects and tracks for itself (mode_holders.hpp), has
// its turn among the others (turn_queue.hpp), is told who holds what it cannot have (`busy`), and lets go of everything
// when it dies.
//
//   VisionAgent vision(context, camera, &streams);
//   Job job = executor.spawn(...vision.run()...);

#include <memory>
#include <vector>

#include "agents/runtime/agent.hpp"
#include "agents/vision/agent/known_bodies.hpp"
#include "agents/vision/agent/printed_tag.hpp"
#include "agents/vision/sight/tags_in_view.hpp"
#include "blackboard/stream.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

struct VisionOptions {
  // The folder of the object database; empty: what was learned is kept on the board alone.
  std::string objects_directory;
  // Tags that are told as they come into view, although nobody asked. The camera is open all the time then.
  std::vector<SizedFamily> tags = {};
  // Objects that are known by their tags from the beginning. An object that is known already stays as it is.
  std::vector<TaggedObject> tagged = {};
  // Bodies of which several faces bear these, defined at the beginning.
  std::vector<DefinedBody> bodies = {};
};

class VisionAgent : public runtime::Agent {
 public:
  // `streams` may be null; otherwise images go to NAME-left, NAME-right (as the camera gives them), NAME-grey,
  // NAME-colour (of the left) and NAME-annotated (BGR; twice the size up to 800 px of width) while somebody watches.
  // Both, and the camera, outlive the agent.
  VisionAgent(runtime::AgentContext context, camera::StereoCamera& camera, Streams* streams,
              VisionOptions options = {});
  ~VisionAgent() override;
  Task<Result<void>> run() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pizarra::vision
