#include "agents/vision/agent/vision_agent.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

#include "agents/vision/agent/frame_pace.hpp"
#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/agent/vision_contract.hpp"
#include "agents/vision/agent/vision_operations.hpp"

namespace pizarra::vision {
namespace {

constexpr Duration state_check = 1s;
constexpr Duration rest_check = 1s;
// Of an agent that was busy itself the frame that came meanwhile is looked at first.
constexpr Duration grace = 20ms;

}  // namespace

struct VisionAgent::State {
  State(runtime::AgentContext context, camera::StereoCamera& camera, Streams* streams, VisionOptions options)
      : parts(std::move(context), camera, streams, std::move(options), service, news()) {}

  Task<Result<void>> run();

  Task<void> know_tagged();
  Task<void> define_bodies();
  Task<void> on_frame(camera::StereoFrame frame);
  // While something is tracked and no frame comes, that nothing is seen.
  Task<void> tell_silence();
  Task<void> tell_missed();
  // To those who watch what a person likes to see.
  void show(const camera::StereoFrame& frame, std::vector<TrackSighting> sightings);

  Task<void> camera_changed();
  // Once a second, what has changed without a word.
  Task<void> look_around();
  CameraNews news();

  VisionParts parts;
  VisionOperations operations{parts};
  std::optional<runtime::Service> service;  // it ends first: its handlers wait for the feed
  Job looking_around;
  Job silence;
};

VisionAgent::VisionAgent(runtime::AgentContext context, camera::StereoCamera& camera, Streams* streams,
                         VisionOptions options)
    : state_(std::make_unique<State>(std::move(context), camera, streams, std::move(options))) {}

VisionAgent::~VisionAgent() = default;

Task<Result<void>> VisionAgent::run() { return state_->run(); }

CameraNews VisionAgent::State::news() {
  return {.on_frame = [this](camera::StereoFrame frame) { return on_frame(std::move(frame)); },
          .on_change = [this] { return camera_changed(); },
          .on_searched = [this](const camera::StereoFrame& frame) { show(frame, {}); }};
}

Task<Result<void>> VisionAgent::State::run() {
  // However the run ends, nothing of it goes on.
  struct Ending {
    State& state;
    ~Ending() {
      state.looking_around = Job();
      state.silence = Job();
      state.parts.pictures.stop();
      state.parts.tags.stop();
      state.service.reset();
      state.parts.feed.abandon();
    }
  };
  const Ending ending{*this};
  // Runs repeat only when no image is divided among threads.
  cv::setNumThreads(1);
  Result<runtime::Contract> contract = runtime::contract_from_text(vision_contract);
  if (!contract) co_return fail(contract);
  service.emplace(parts.context, std::move(*contract));
  const Result<void> started = co_await service->start();
  if (!started) co_return started;
  const Result<void> recalled = co_await parts.known.recall();
  if (!recalled) co_return recalled;
  co_await know_tagged();
  co_await define_bodies();
  const Result<void> defined = co_await parts.bodies.recall();
  if (!defined) co_return defined;
  co_await parts.state.tell();
  co_await parts.known.tell();
  if (!parts.tags.empty()) parts.feed.start();
  looking_around = parts.context.executor.spawn(look_around());
  silence = parts.context.executor.spawn(tell_silence());
  runtime::RequestHandler handler = [this](Fact request) { return operations.handle(std::move(request)); };
  const Result<void> served = co_await service->serve_requests(std::move(handler));
  co_return served;
}

// A tag that cannot be learned is told of as if LEARN had failed.
Task<void> VisionAgent::State::know_tagged() {
  for (const TaggedObject& object : parts.options.tagged) {
    const Result<void> known_now = co_await parts.known.know(object);
    if (known_now) continue;
    std::string text = learn_reply(object.name, false);
    [[maybe_unused]] const Result<Datum> told = co_await parts.answer_failed(std::move(text), known_now.error());
  }
}

Task<void> VisionAgent::State::define_bodies() {
  for (const DefinedBody& body : parts.options.bodies) {
    const Result<Datum> defined = co_await parts.bodies.define(body.marks, body.name);
    if (defined) continue;
    std::string text = learn_reply(body.name, false);
    [[maybe_unused]] const Result<Datum> told = co_await parts.answer_failed(std::move(text), defined.error());
  }
}

Task<void> VisionAgent::State::on_frame(camera::StereoFrame frame) {
  std::vector<TrackSighting> sightings;
  const bool tracks = !parts.holders.finding() && !parts.tracker.empty() && parts.tracking_turn.is_due(frame);
  if (tracks) {
    StereoSight sight(frame, *parts.feed.model());
    sightings = parts.tracker.update(sight, frame.captured);
    const double focal_px = parts.feed.model()->focal_px;
    parts.tracker.look_within(parts.bodies.areas_of_unseen(sightings, frame.captured, focal_px));
    parts.tracking_turn.looked_at(frame);
  }
  parts.tags.look_at(frame, *parts.feed.model());
  parts.pictures.publish(frame);
  // A frame that was taken for finds is shown by the find, with what it found.
  const bool is_shown_here = !parts.holders.finding();
  // The arm waits for what is told; whoever looks on may wait for the picture.
  const auto is_new = [&](const TrackSighting& sighting) { return sighting.captured == frame.captured; };
  const bool tells = tracks && parts.holders.connected() && std::ranges::any_of(sightings, is_new);
  const std::vector<TrackSighting> told = parts.bodies.told(sightings);
  if (tells) co_await parts.looks.tell(frame.number, told);
  if (is_shown_here) show(frame, std::move(sightings));
}

Task<void> VisionAgent::State::tell_silence() {
  FramePace pace;
  Time last = parts.context.executor.now();
  while (true) {
    const Duration patience = parts.tracker.empty() && parts.tags.empty() ? rest_check : pace.patience();
    const Result<camera::StereoFrame> frame = co_await parts.feed.next(last, patience);
    if (frame) {
      last = frame->captured;
      pace.came(last);
      continue;
    }
    if (parts.feed.state() != CameraFeed::State::open) pace.rest();
    co_await sleep(parts.context.executor, grace);
    const bool silent = parts.feed.state() == CameraFeed::State::open && parts.feed.latest() <= last;
    if (!silent) continue;
    co_await tell_missed();
    co_await parts.tags.tell_none(parts.feed.frame_number(), parts.feed.latest());
  }
}

Task<void> VisionAgent::State::tell_missed() {
  if (parts.holders.finding()) co_return;
  const std::vector<TrackSighting> sightings = parts.bodies.told(parts.tracker.miss_all(parts.context.executor.now()));
  if (sightings.empty() || !parts.holders.connected()) co_return;
  co_await parts.looks.tell(parts.feed.frame_number(), sightings);
}

void VisionAgent::State::show(const camera::StereoFrame& frame, std::vector<TrackSighting> sightings) {
  if (!parts.pictures.person_watches()) return;
  Annotation annotation;
  annotation.sightings = std::move(sightings);
  parts.search.add_to(annotation);
  annotation.status = fmt::format("{}{}", parts.state.mode(), parts.holders.connected() ? "" : " (not connected)");
  parts.pictures.show(frame, annotation);
}

Task<void> VisionAgent::State::camera_changed() {
  co_await parts.state.tell();
  if (parts.feed.state() == CameraFeed::State::open) co_return;
  parts.tracking_turn.let_go();
  co_await parts.looks.unsay();
  parts.tags.stop();
  co_await parts.tags.unsay();
}

Task<void> VisionAgent::State::look_around() {
  while (true) {
    co_await sleep(parts.context.executor, state_check);
    const bool lost = parts.facts.lost();
    const bool news = lost || parts.state.has_news();
    if (news) co_await parts.state.tell();
    if (lost) co_await parts.known.tell();
    co_await parts.known.follow_memory();
    const bool let_go = co_await parts.presence.let_dead_go(parts.holders);
    if (let_go) co_await parts.follow_holders();
  }
}

}  // namespace pizarra::vision
