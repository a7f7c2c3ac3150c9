// The tags in view, told although nobody has asked for them.

#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

// In virtual time; what a pair of 640 x 480 takes.
constexpr Duration reading_cost = 20ms;

// A look at one frame, which may outlive whoever began it.
struct TagReading {
  camera::StereoFrame frame;
  camera::StereoModel model;
  TagsInView tags;
  std::vector<FoundMark> seen = {};

  void read() {
    const GreyPair grey = grey_pair(frame);
    const StereoSight sight(grey.left, grey.right, model);
    seen = tags.at(sight);
  }
};

}  // namespace

void VisionAgent::State::begin_reading_tags(const camera::StereoFrame& frame) {
  if (!tags.empty() && reading.done()) reading = context.executor.spawn(read_tags(frame));
}

Task<void> VisionAgent::State::read_tags(camera::StereoFrame frame) {
  const auto look = std::make_shared<TagReading>(std::move(frame), *feed.model(), tags);
  std::function<void(const std::function<bool()>&)> read = [look](const std::function<bool()>& cancelled) {
    if (!cancelled()) look->read();
  };
  co_await context.executor.offload(std::move(read), reading_cost);
  co_await facts.tell_tags(look->frame.number, look->frame.captured, std::move(look->seen));
}

}  // namespace pizarra::vision
