#include "tests/agents/vision/tilted_looks.hpp"

#include "agents/vision/sight/mark_learner.hpp"

namespace pizarra::vision {

TiltedLooks::TiltedLooks(const camera::StereoModel& seen_by) : camera(seen_by), views_(seen_by, {}) {}

StereoSight TiltedLooks::sight_of(const RangeView& view, Side side, Random& random) const {
  const cv::Mat1b left = views_.draw(view, false, random);
  const bool one = camera.is_single() || side == Side::left_alone;
  return {left, one ? cv::Mat1b(left.size(), std::uint8_t{165}) : views_.draw(view, true, random), camera};
}

void TiltedLooks::learn(const RangeView& view, Random& random) {
  MarkLearner learner(view.mark, views_.seen_at(view.place, false), objects);
  while (!learner.done()) {
    StereoSight sight = sight_of(view, Side::both, random);
    learner.feed(sight).value();
  }
  LearnedSample sample = learner.sample();
  sample.number = 1;
  objects.add(view.mark, std::move(sample));
}

Result<FoundMark> TiltedLooks::find(const RangeView& view, Side side, Random& random) const {
  StereoSight sight = sight_of(view, side, random);
  return MarkFinder(objects).find(sight, *objects.find(view.mark), Time());
}

std::vector<TrackSighting> TiltedLooks::follow(const std::vector<RangeView>& views, Random& random) const {
  MarkTracker tracker(objects);
  tracker.add(*objects.find(views.front().mark)).value();
  std::vector<TrackSighting> out;
  Time now;
  for (const RangeView& view : views) {
    StereoSight sight = sight_of(view, Side::both, random);
    out.push_back(tracker.update(sight, now += std::chrono::milliseconds(33)).front());
  }
  return out;
}

TrackSighting TiltedLooks::track(const RangeView& view, int frames, Random& random) const {
  return follow(std::vector<RangeView>(static_cast<std::size_t>(frames), view), random).back();
}

}  // namespace pizarra::vision
