#include "agents/vision/agent/vision_agent.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/agent/vision_replies.hpp"
#include "agents/vision/agent/vision_state.hpp"
#include "agents/vision/objects/look_alike.hpp"

namespace pizarra {
namespace {

constexpr std::string_view contract_text = R"(
(contract vision
  (offers
    (learn (x number) (y number) (name string))
    (find (name string))
    (track (name string))
    (end-track)
    (get-objects)
    (connect)
    (disconnect)
    (accept (name string))
    (reject (name string))
    (forget (name string))
    (rename (name string) (new-name string)))
  (posts
    (relation vision-mode ((mode symbol) (connected symbol)) (key))
    (relation vision-held ((client symbol) (mode symbol)) (key client mode))
    (relation vision-says ((frame integer) (text string)) (key))
    (relation faces ((frame integer) (turned list)) (key))
    (relation sightings ((frame integer) (of list)) (key))
    (relation tracked ((name string) (state symbol) (frame integer) (confidence number)) (key name))
    (relation found ((name string) (frame integer) (confidence number) (second string) (margin number)
                     (elsewhere list)) (key name))
    (relation vision-failed ((frame integer) (text string) (symbol symbol) (sentence string)) (key))
    (relation learned ((name string) (num integer) (area number) (perimeter number) (features integer)
                       (m0 number) (m1 number) (m2 number)) (key name num) (durable))
    (relation learned-template ((name string) (num integer) (tone symbol) (height number) (slimness number)
                                (roundness number) (roundness-spread number) (size number) (picture string))
                               (key name num) (durable))
    (relation to-accept ((name string) (num integer)) (key))
    (relation look-alike ((name string) (other string) (error number) (sentence string)) (key name other))
    (relation objects-damaged ((file string) (symbol symbol) (sentence string)) (key file))
    (relation camera-model ((width integer) (height integer) (focal number) (cx number) (cy number)
                            (base-line number)) (key))
    (relation camera-state ((state symbol) (trouble string)) (key))
    (relation camera-drops ((late integer) (skewed integer) (corrupt integer)) (key))
    (relation stream ((name symbol) (kind symbol) (place list)) (key name)))
  (reads frames)
  (configures (learn accept reject forget rename connect disconnect))
  (monitors (vision-mode camera-state objects-damaged)))
)";

std::string_view state_name(CameraFeed::State state) {
  switch (state) {
    case CameraFeed::State::closed:
      return "closed";
    case CameraFeed::State::opening:
      return "opening";
    case CameraFeed::State::open:
      return "open";
    case CameraFeed::State::lost:
      break;
  }
  return "lost";
}

constexpr Duration state_check = 1s;

// What can be watched: the pair as the camera gives it, the eyes' grey, the same in colour, and what a person likes to
// see.
constexpr std::string_view stream_kinds[] = {"left", "right", "grey", "colour", "annotated"};

}  // namespace

VisionAgent::VisionAgent(AgentContext context, StereoCamera& camera, Streams* streams, VisionOptions options)
    : state_(std::make_unique<State>(std::move(context), camera, streams, std::move(options))) {}

VisionAgent::~VisionAgent() = default;

Task<Result<void>> VisionAgent::run() { return state_->run(); }

VisionAgent::State::State(AgentContext agent_context, StereoCamera& stereo_camera, Streams* image_streams,
                          VisionOptions vision_options)
    : context(std::move(agent_context)),
      options(std::move(vision_options)),
      camera(stereo_camera),
      streams(image_streams),
      memory(context, options.objects_directory),
      feed(
          context.executor, stereo_camera, [this](StereoFrame frame) { return on_frame(std::move(frame)); },
          [this] { return camera_changed(); }),
      turn_ended(context.executor) {}

Task<Result<void>> VisionAgent::State::run() {
  // However the run ends, nothing of it goes on.
  struct Ending {
    State& state;
    ~Ending() {
      state.again = Job();
      state.showing = Job();
      state.service.reset();
      state.feed.abandon();
    }
  };
  const Ending ending{*this};
  // Runs repeat only when no image is divided among threads.
  cv::setNumThreads(1);
  Result<Contract> contract = contract_from_text(contract_text);
  if (!contract) co_return fail(contract);
  service.emplace(context, std::move(*contract));
  const Result<void> started = co_await service->start();
  if (!started) co_return started;
  const Result<void> recalled = co_await memory.recall();
  if (!recalled) co_return recalled;
  co_await tell_state();
  co_await tell_objects();
  again = context.executor.spawn(tell_state_again());
  RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  const Result<void> served = co_await service->serve_requests(std::move(handler));
  co_return served;
}

Task<Result<Datum>> VisionAgent::State::handle(Fact request) {
  const Datum& operation = request.datum[3];
  const std::string_view asked = operation.head();
  // Of operations that take one.
  const std::string name = operation.size() > 1 ? std::string(operation.items().back().text()) : "";
  if (asked == "learn") return learn(request.teller, operation[1].number(), operation[2].number(), name);
  if (asked == "find") return find(request.teller, name);
  if (asked == "track") return track(request.teller, name);
  if (asked == "end-track") return end_track(request.teller);
  if (asked == "connect") return connect(request.teller);
  if (asked == "disconnect") return disconnect(request.teller);
  if (asked == "accept") return accept(name);
  if (asked == "reject") return reject(name);
  if (asked == "forget") return forget(name);
  if (asked == "rename") return rename(std::string(operation[1].text()), name);
  return get_objects();
}

// Facts stand under the agent's presence, so that they go with it.
Task<void> VisionAgent::State::tell(std::vector<Datum> facts) {
  Transaction transaction;
  for (Datum& fact : facts) transaction.tell(std::move(fact), {}, service->presence());
  const Result<Revision> told = co_await context.board.transact(std::move(transaction));
  // Board away or presence lapsed: tell_state_again() mends what lasts, the next frame the rest.
  if (!told) told_under = 0;
}

Task<void> VisionAgent::State::tell_state() {
  // What was told under another presence went with it.
  if (told_under != service->presence()) told_tracks.clear();
  told_under = service->presence();
  std::vector<Datum> facts;
  facts.push_back(list("vision-mode"_sym, Datum::symbol(mode()), Datum::symbol(holders.connected() ? "yes" : "no")));
  facts.push_back(list("camera-state"_sym, Datum::symbol(state_name(feed.state())), feed.trouble()));
  if (const std::optional<StereoModel>& model = feed.model()) {
    facts.push_back(list("camera-model"_sym, model->width, model->height, model->focal_px, model->centre_x_px,
                         model->centre_y_px, model->base_line_mm));
  }
  told_drops = camera.drops();
  if (told_drops != CameraDrops()) {
    facts.push_back(list("camera-drops"_sym, told_drops.late, told_drops.skewed, told_drops.corrupt));
  }
  if (streams != nullptr) {
    for (const std::string_view kind : stream_kinds) facts.push_back(stream_fact(stream(kind), kind, *streams));
  }
  co_await tell(std::move(facts));
  co_await tell_holders();
}

Task<void> VisionAgent::State::tell_holders() {
  std::vector<Datum> facts = holders.facts();
  const bool busy = activity == Activity::learning || activity == Activity::finding;
  if (busy) facts.push_back(list("vision-held"_sym, Datum::symbol(busy_for), Datum::symbol(mode())));
  Transaction transaction;
  for (const Datum& fact : told_held) {
    if (std::ranges::find(facts, fact) == facts.end()) transaction.retract(fact);
  }
  told_held = facts;
  for (Datum& fact : facts) transaction.tell(std::move(fact), {}, service->presence());
  if (transaction.steps.empty()) co_return;
  const Result<Revision> told = co_await context.board.transact(std::move(transaction));
  if (!told) told_under = 0;
}

Task<void> VisionAgent::State::tell_state_again() {
  while (true) {
    co_await sleep(context.executor, state_check);
    const bool lapsed = told_under != service->presence();
    const bool news = lapsed || told_drops != camera.drops();
    if (news) co_await tell_state();
    if (lapsed) co_await tell_objects();
    co_await follow_memory();
    co_await let_dead_go();
  }
}

Task<void> VisionAgent::State::tell_objects() {
  Transaction transaction;
  const LeaseId presence = service->presence();
  transaction.retract(list("to-accept"_sym, "?"_sym, "?"_sym));
  transaction.retract(list("look-alike"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym));
  transaction.retract(list("objects-damaged"_sym, "?"_sym, "?"_sym, "?"_sym));
  if (to_accept) transaction.tell(list("to-accept"_sym, to_accept->name, to_accept->number), {}, presence);
  for (Datum& fact : look_alikes(objects)) transaction.tell(std::move(fact), {}, presence);
  for (const Failure& trouble : memory.troubles()) {
    Datum fact = list("objects-damaged"_sym, trouble.subject, Datum::symbol(trouble.symbol), trouble.sentence);
    transaction.tell(std::move(fact), {}, presence);
  }
  const Result<Revision> told = co_await context.board.transact(std::move(transaction));
  if (!told) told_under = 0;
}

Task<void> VisionAgent::State::follow_memory() {
  const Result<bool> changed = co_await memory.recall_changed();
  const bool anew = changed && *changed;
  if (anew) co_await tell_objects();
}

Task<void> VisionAgent::State::camera_changed() {
  co_await tell_state();
  if (feed.state() == CameraFeed::State::open) co_return;
  const Result<void> unsaid = co_await unsay();
  if (!unsaid) told_under = 0;
}

Task<Result<void>> VisionAgent::State::unsay() {
  told_tracks.clear();
  Transaction transaction;
  transaction.retract(list("vision-says"_sym, "?"_sym, "?"_sym));
  transaction.retract(list("sightings"_sym, "?"_sym, "?"_sym));
  transaction.retract(list("tracked"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym));
  const Result<Revision> retracted = co_await context.board.transact(std::move(transaction));
  if (!retracted) co_return fail(retracted);
  co_return Result<void>();
}

std::string_view VisionAgent::State::mode() const {
  switch (activity) {
    case Activity::learning:
      return "learning";
    case Activity::finding:
      return "finding";
    case Activity::tracking:
      return "tracking";
    case Activity::none:
      break;
  }
  return feed.wanted() ? "capturing" : "idle";
}

Task<void> VisionAgent::State::on_frame(StereoFrame frame) {
  std::vector<TrackSighting> sightings;
  if (activity == Activity::tracking) {
    const GreyPair grey = grey_pair(frame);
    StereoSight sight(grey.left, grey.right, *feed.model());
    sightings = tracker.update(sight);
  }
  publish(frame, sightings);
  if (activity != Activity::tracking || !holders.connected()) co_return;
  std::vector<Datum> facts;
  // What is concluded from the reply finds the faces of its frame there already.
  facts.push_back(faces_fact(frame.number, sightings));
  facts.push_back(sightings_fact(frame.number, sightings));
  for (const TrackSighting& sighting : sightings) {
    const std::string_view state = track_state(sighting);
    std::string& told = told_tracks[sighting.name];
    if (told == state) continue;
    told = state;
    const double confidence = std::round(sighting.confidence * 1000) / 1000;
    facts.push_back(list("tracked"_sym, sighting.name, Datum::symbol(state), frame.number, confidence));
  }
  facts.push_back(list("vision-says"_sym, frame.number, track_reply(sightings)));
  co_await tell(std::move(facts));
}

std::string VisionAgent::State::stream(std::string_view kind) const { return fmt::format("{}-{}", context.name, kind); }

bool VisionAgent::State::watched(std::string_view kind) const { return streams->watched(stream(kind)); }

void VisionAgent::State::publish(const StereoFrame& frame, const std::vector<TrackSighting>& sightings) {
  if (streams == nullptr) return;
  const auto send = [&](std::string_view kind, std::shared_ptr<const Image> image) {
    streams->publish(stream(kind), {frame.number, frame.captured, std::move(image)});
  };
  if (watched("left")) send("left", frame.left);
  if (watched("right")) send("right", frame.right);
  if (watched("grey")) send("grey", grey_image(frame.left));
  if (!(watched("colour") || watched("annotated")) || !showing.done()) return;
  Annotation annotation{.sightings = sightings, .filled = {}, .learned_contour = {}, .status = {}};
  if (learner) {
    annotation.learned_contour = learner->contour();
    if (learner->contour().empty()) annotation.filled = learner->filled().clone();
  }
  annotation.status =
      fmt::format("frame {}   {}{}", frame.number, mode(), holders.connected() ? "" : " (not connected)");
  showing = context.executor.spawn(show(frame, std::move(annotation)));
}

// The eyes' own images are always grey, so that nothing they tell depends on who watches: the same frame, or the next
// where the camera has moved on, is asked for once more in colour.
Task<void> VisionAgent::State::show(StereoFrame frame, Annotation annotation) {
  const std::uint64_t before = frame.number - 1;
  const Result<StereoFrame> coloured = co_await camera.next(before, true);
  const bool usable = coloured && coloured->left != nullptr && coloured->left->width == frame.left->width;
  const StereoFrame& base = usable ? *coloured : frame;
  if (watched("colour")) streams->publish(stream("colour"), {base.number, base.captured, base.left});
  if (!watched("annotated")) co_return;
  streams->publish(stream("annotated"), {frame.number, frame.captured, annotate(*base.left, annotation)});
}

namespace {

// Shares the pixels of what is grey already.
cv::Mat grey(const Image& image) {
  cv::Mat view(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  if (image.channels == 3) cv::cvtColor(view, view, cv::COLOR_BGR2GRAY);
  return view;
}

}  // namespace

GreyPair grey_pair(const StereoFrame& frame) { return {grey(*frame.left), grey(*frame.right)}; }

std::shared_ptr<const Image> grey_image(const std::shared_ptr<const Image>& image) {
  if (image->channels == 1) return image;
  const cv::Mat view = grey(*image);
  return std::make_shared<Image>(Image{image->width, image->height, 1, {view.datastart, view.dataend}});
}

}  // namespace pizarra
