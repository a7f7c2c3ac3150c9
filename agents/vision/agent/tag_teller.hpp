#pragma once

// Tells the tags in view, although nobody has asked for them. However long a look takes, one is in hand, away from the
// executor's thread; frames that come meanwhile are not looked at.
//
//   TagTeller tags(executor, facts, options.tags);
//   tags.look_at(frame, model);           // each frame
//   co_await tags.tell_none(number, captured);         // no frame came any more
//   co_await tags.unsay();                             // the camera is lost
//   tags.stop();                          // before it is destroyed, where a look may be in hand

#include "agents/vision/agent/fact_teller.hpp"
#include "agents/vision/sight/tags_in_view.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

class TagTeller {
 public:
  // `facts` outlives it.
  TagTeller(Executor& executor, FactTeller& facts, std::span<const SizedFamily> families)
      : executor_(executor), facts_(facts), tags_(families) {}

  // Nothing is to be told.
  bool empty() const { return tags_.empty(); }
  void look_at(const camera::StereoFrame& frame, const camera::StereoModel& model);
  Task<void> tell_none(std::uint64_t frame, Time captured);
  // Retracts what was told of earlier frames.
  Task<void> unsay();
  void stop() { reading_ = Job(); }

 private:
  Task<void> read(camera::StereoFrame frame, camera::StereoModel model);
  // That there are none is told once.
  Task<void> tell(std::uint64_t frame, Time captured, std::vector<FoundMark> seen);

  Executor& executor_;
  FactTeller& facts_;
  const TagsInView tags_;
  std::uint64_t beginning_ = 0;  // of the facts of which is remembered:
  bool told_none_ = false;       // by what was told last
  Job reading_;
};

}  // namespace pizarra::vision
