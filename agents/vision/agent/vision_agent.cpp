#include "agents/vision/agent/vision_agent.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

#include "agents/vision/agent/frame_pace.hpp"
#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/agent/vision_contract.hpp"
#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

constexpr Duration state_check = 1s;
constexpr Duration rest_check = 1s;
// Of an agent that was busy itself the frame that came meanwhile is looked at first.
constexpr Duration grace = 20ms;

}  // namespace

VisionAgent::VisionAgent(runtime::AgentContext context, camera::StereoCamera& camera, Streams* streams,
                         VisionOptions options)
    : state_(std::make_unique<State>(std::move(context), camera, streams, std::move(options))) {}

VisionAgent::~VisionAgent() = default;

Task<Result<void>> VisionAgent::run() { return state_->run(); }

VisionAgent::State::State(runtime::AgentContext agent_context, camera::StereoCamera& stereo_camera,
                          Streams* image_streams, VisionOptions vision_options)
    : context(std::move(agent_context)),
      options(std::move(vision_options)),
      known(context, options.objects_directory, holders, presence, facts,
            [this](const Renames& renames) {
              search.rename(renames);
              tracker.rename(renames);
            }),
      pictures(context, stereo_camera, image_streams),
      feed(
          context.executor, stereo_camera, [this](camera::StereoFrame frame) { return on_frame(std::move(frame)); },
          [this] { return camera_changed(); }),
      search(context.executor, feed, known,
             [this](const camera::StereoFrame& frame) {
               tracking_turn.was_passed_over(frame);
               show(frame, {});
             }),
      state(stereo_camera, feed, holders, tracker, pictures, facts) {}

Task<Result<void>> VisionAgent::State::run() {
  // However the run ends, nothing of it goes on.
  struct Ending {
    State& state;
    ~Ending() {
      state.looking_around = Job();
      state.silence = Job();
      state.pictures.stop();
      state.tags.stop();
      state.service.reset();
      state.feed.abandon();
    }
  };
  const Ending ending{*this};
  // Runs repeat only when no image is divided among threads.
  cv::setNumThreads(1);
  Result<runtime::Contract> contract = runtime::contract_from_text(vision_contract);
  if (!contract) co_return fail(contract);
  service.emplace(context, std::move(*contract));
  const Result<void> started = co_await service->start();
  if (!started) co_return started;
  const Result<void> recalled = co_await known.recall();
  if (!recalled) co_return recalled;
  co_await know_tagged();
  co_await define_bodies();
  const Result<void> defined = co_await bodies.recall();
  if (!defined) co_return defined;
  co_await state.tell();
  co_await known.tell();
  if (!tags.empty()) feed.start();
  looking_around = context.executor.spawn(look_around());
  silence = context.executor.spawn(tell_silence());
  runtime::RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  const Result<void> served = co_await service->serve_requests(std::move(handler));
  co_return served;
}

// A tag that cannot be learned is told of as if LEARN had failed.
Task<void> VisionAgent::State::know_tagged() {
  for (const TaggedObject& object : options.tagged) {
    const Result<void> known_now = co_await known.know(object);
    if (known_now) continue;
    std::string text = learn_reply(object.name, false);
    [[maybe_unused]] const Result<Datum> told = co_await answer_failed(std::move(text), known_now.error());
  }
}

Task<void> VisionAgent::State::define_bodies() {
  for (const DefinedBody& body : options.bodies) {
    const Result<Datum> defined = co_await bodies.define(body.marks, body.name);
    if (defined) continue;
    std::string text = learn_reply(body.name, false);
    [[maybe_unused]] const Result<Datum> told = co_await answer_failed(std::move(text), defined.error());
  }
}

Task<void> VisionAgent::State::on_frame(camera::StereoFrame frame) {
  std::vector<TrackSighting> sightings;
  const bool tracks = !holders.finding() && !tracker.empty() && tracking_turn.is_due(frame);
  if (tracks) {
    StereoSight sight(frame, *feed.model());
    sightings = tracker.update(sight, frame.captured);
    tracking_turn.looked_at(frame);
  }
  tags.look_at(frame, *feed.model());
  pictures.publish(frame);
  // A frame that was taken for finds is shown by the find, with what it found.
  const bool is_shown_here = !holders.finding();
  // The arm waits for what is told; whoever looks on may wait for the picture.
  const auto is_new = [&](const TrackSighting& sighting) { return sighting.captured == frame.captured; };
  const bool tells = tracks && holders.connected() && std::ranges::any_of(sightings, is_new);
  const std::vector<TrackSighting> told = bodies.told(sightings);
  if (tells) co_await facts.tell_look(frame.number, told);
  if (is_shown_here) show(frame, std::move(sightings));
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
    co_await tags.tell_none(feed.frame_number(), feed.latest());
  }
}

Task<void> VisionAgent::State::tell_missed() {
  if (holders.finding()) co_return;
  const std::vector<TrackSighting> sightings = bodies.told(tracker.miss_all(context.executor.now()));
  if (sightings.empty() || !holders.connected()) co_return;
  co_await facts.tell_look(feed.frame_number(), sightings);
}

void VisionAgent::State::show(const camera::StereoFrame& frame, std::vector<TrackSighting> sightings) {
  if (!pictures.person_watches()) return;
  Annotation annotation;
  annotation.sightings = std::move(sightings);
  search.add_to(annotation);
  annotation.status = fmt::format("{}{}", state.mode(), holders.connected() ? "" : " (not connected)");
  pictures.show(frame, annotation);
}

Task<void> VisionAgent::State::camera_changed() {
  co_await state.tell();
  if (feed.state() == CameraFeed::State::open) co_return;
  tracking_turn.let_go();
  co_await facts.unsay();
  tags.stop();
  co_await facts.unsay_tags();
}

Task<void> VisionAgent::State::follow_holders() {
  tracker.keep_only(bodies.marks_of(holders.tracked()));
  if (tracker.empty()) tracking_turn.let_go();
  turns.wake();
  co_await rest_or_go_on();
  if (!tracker.empty() && holders.connected()) co_return;
  co_await facts.unsay();
}

Task<void> VisionAgent::State::rest_or_go_on() {
  const bool busy = holders.learning() || holders.finding() || !tracker.empty() || !tags.empty();
  if (!busy && !holders.connected()) feed.stop();
  co_await state.tell();
}

Task<void> VisionAgent::State::look_around() {
  while (true) {
    co_await sleep(context.executor, state_check);
    const bool lost = facts.lost();
    const bool news = lost || state.has_news();
    if (news) co_await state.tell();
    if (lost) co_await known.tell();
    co_await known.follow_memory();
    const bool let_go = co_await presence.let_dead_go(holders);
    if (let_go) co_await follow_holders();
  }
}

}  // namespace pizarra::vision
