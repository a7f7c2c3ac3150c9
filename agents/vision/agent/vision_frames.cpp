// What becomes of each frame: it is looked at, told of, and shown to whoever watches.

#include <algorithm>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

// What can be watched: the pair as the camera gives it, the eyes' grey, the same in colour, and what a person likes to
// see.
constexpr std::string_view stream_kinds[] = {"left", "right", "grey", "colour", "annotated"};

constexpr Duration found_shown_for = 3s;
constexpr Duration rest_check = 1s;
// Of an agent that was busy itself the frame that came meanwhile is looked at first.
constexpr Duration grace = 20ms;

// Shares the pixels of what is grey already.
cv::Mat grey(const Image& image) {
  cv::Mat view(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  if (image.channels == 3) cv::cvtColor(view, view, cv::COLOR_BGR2GRAY);
  return view;
}

}  // namespace

Task<void> VisionAgent::State::on_frame(camera::StereoFrame frame) {
  std::vector<TrackSighting> sightings;
  const bool tracks = !tracker.empty() && finding_for.empty() && frame.captured > tracking_asked;
  if (tracks) {
    const GreyPair grey = grey_pair(frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    sightings = tracker.update(sight, frame.captured);
    tracked_image = frame.left;
    tracking_is_next = false;
    turns_changed.wake_all();
  }
  begin_reading_tags(frame);
  publish(frame);
  // A frame that was taken for finds is shown by the find, with what it found.
  if (finding_for.empty()) begin_showing(frame, sightings);
  if (!tracks || !holders.connected()) co_return;
  co_await facts.tell_look(frame.number, sightings);
}

Task<void> VisionAgent::State::tell_silence() {
  FramePace pace;
  Time last = context.executor.now();
  while (true) {
    const Duration patience = tracker.empty() && tags.empty() ? rest_check : pace.patience();
    const Result<camera::StereoFrame> frame = co_await feed.next(last, patience);
    if (frame) {
      last = frame->captured;
      pace.came(last);
      continue;
    }
    if (feed.state() != CameraFeed::State::open) pace.rest();
    co_await sleep(context.executor, grace);
    const bool silent = feed.state() == CameraFeed::State::open && feed.latest() <= last;
    if (!silent) continue;
    co_await tell_missed();
    const std::vector<FoundMark> none;
    if (!tags.empty()) co_await facts.tell_tags(feed.frame_number(), feed.latest(), none);
  }
}

Task<void> VisionAgent::State::tell_missed() {
  if (!finding_for.empty()) co_return;
  const std::vector<TrackSighting> sightings = tracker.miss_all(context.executor.now());
  if (sightings.empty() || !holders.connected()) co_return;
  co_await facts.tell_look(feed.frame_number(), sightings);
}

std::string VisionAgent::State::stream(std::string_view kind) const { return fmt::format("{}-{}", context.name, kind); }

// Streams have the agent's name already, so this fact does not begin with it.
Task<void> VisionAgent::State::tell_streams() {
  if (streams == nullptr) co_return;
  Transaction transaction;
  for (const std::string_view kind : stream_kinds) {
    transaction.tell(stream_fact(stream(kind), kind, *streams), {}, service->presence());
  }
  co_await facts.transact(std::move(transaction));
}

bool VisionAgent::State::watched(std::string_view kind) const { return streams->watched(stream(kind)); }

void VisionAgent::State::publish(const camera::StereoFrame& frame) {
  if (streams == nullptr) return;
  const auto send = [&](std::string_view kind, std::shared_ptr<const Image> image) {
    streams->publish(stream(kind), {frame.number, frame.captured, std::move(image)});
  };
  if (watched("left")) send("left", frame.left);
  if (watched("right")) send("right", frame.right);
  if (watched("grey")) send("grey", grey_image(frame.left));
}

void VisionAgent::State::begin_showing(const camera::StereoFrame& frame, std::vector<TrackSighting> sightings) {
  if (streams == nullptr || !(watched("colour") || watched("annotated")) || !showing.done()) return;
  showing = context.executor.spawn(show(frame, annotation_for(frame.number, std::move(sightings))));
}

Annotation VisionAgent::State::annotation_for(std::uint64_t frame, std::vector<TrackSighting> sightings) const {
  Annotation out{.sightings = std::move(sightings),
                 .found = finder.found_since(context.executor.now() - found_shown_for),
                 .filled = {},
                 .learned_contour = {},
                 .status = {}};
  std::erase_if(out.found, [&](const FoundPlace& found) {
    return std::ranges::find(out.sightings, found.name, &TrackSighting::name) != out.sightings.end();
  });
  if (learner) {
    out.learned_contour = learner->contour();
    if (learner->contour().empty()) out.filled = learner->filled_so_far();
  }
  out.status = fmt::format("frame {}   {}{}", frame, mode(), holders.connected() ? "" : " (not connected)");
  return out;
}

// The eyes' own images are always grey, so that nothing they tell depends on who watches: the same frame, or the next
// where the camera has moved on, is asked for once more in colour. While they learn or track, the picture of it stays
// grey, as the thesis has it, and what they mark stands out.
Task<void> VisionAgent::State::show(camera::StereoFrame frame, Annotation annotation) {
  const Time before = frame.captured - Duration(1);
  const Result<camera::StereoFrame> coloured = co_await camera.next(before, true);
  const bool usable = coloured && coloured->left != nullptr && coloured->left->width == frame.left->width &&
                      coloured->left->height == frame.left->height;
  const camera::StereoFrame& base = usable ? *coloured : frame;
  if (watched("colour")) streams->publish(stream("colour"), {base.number, base.captured, base.left});
  if (!watched("annotated")) co_return;
  const bool learning = !annotation.filled.empty() || !annotation.learned_contour.empty();
  const bool grey = learning || !annotation.sightings.empty();
  const Image& shown = grey ? *frame.left : *base.left;
  streams->publish(stream("annotated"), {frame.number, frame.captured, annotate(shown, annotation)});
}

GreyPair grey_pair(const camera::StereoFrame& frame) { return {grey(*frame.left), grey(*frame.right)}; }

std::shared_ptr<const Image> grey_image(const std::shared_ptr<const Image>& image) {
  if (image->channels == 1) return image;
  const cv::Mat view = grey(*image);
  return std::make_shared<Image>(Image{image->width, image->height, 1, {view.datastart, view.dataend}});
}

}  // namespace pizarra::vision
