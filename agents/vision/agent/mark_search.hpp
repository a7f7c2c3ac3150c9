#pragma once

// Learning and finding, over as many frames of the camera as they take.
//
//   MarkSearch search(executor, feed, known, [&](const camera::StereoFrame& frame) { ... });
//   Result<LearnedSample> sample = co_await search.learn("circle", {160, 120}, std::nullopt, asked);
//   Result<FoundMark> found = co_await search.find("circle", {"circle"}, asked);

#include "agents/vision/agent/camera_feed.hpp"
#include "agents/vision/agent/known_objects.hpp"
#include "agents/vision/sight/annotate.hpp"
#include "agents/vision/sight/mark_learner.hpp"

namespace pizarra::vision {

class MarkSearch {
 public:
  // Is told each frame that a finding has looked at.
  using LookHandler = std::function<void(const camera::StereoFrame& frame)>;

  // All outlive it.
  MarkSearch(Executor& executor, CameraFeed& feed, const KnownObjects& known, LookHandler on_find_look)
      : executor_(executor), feed_(feed), known_(known), on_find_look_(std::move(on_find_look)) {}

  // `clicked`: the frame that was pointed at; where none is said, the next one after it was asked. The picture
  // shows the filled-in area until forget_learning(). Failures: frame-gone, no-image, those of MarkLearner.
  Task<Result<LearnedSample>> learn(std::string name, cv::Point2d click, std::optional<std::uint64_t> clicked,
                                    Time asked);
  void forget_learning() { learner_.reset(); }
  // In up to three frames that were captured after it was asked, the surest of its marks: of an object itself.
  // Failures: not-learned, damaged, full, no-image, those of MarkFinder.
  Task<Result<FoundMark>> find(std::string name, std::set<std::string> marks, Time asked);
  // Where it was found last, in whatever image.
  std::optional<cv::Point2d> place_of(const std::string& name) const { return finder_.place_of(name); }
  void rename(const Renames& renames) { finder_.rename(renames); }
  // What a person sees of it.
  void add_to(Annotation& annotation) const;

 private:
  Result<FoundMark> find_in(const camera::StereoFrame& frame, const std::string& name,
                            const std::set<std::string>& marks);

  Executor& executor_;
  CameraFeed& feed_;
  const KnownObjects& known_;
  LookHandler on_find_look_;
  MarkFinder finder_{known_.objects()};
  std::optional<MarkLearner> learner_;
};

}  // namespace pizarra::vision
