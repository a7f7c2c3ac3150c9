// How and when the eyes' state is told to the board.

#include "agents/vision/agent/vision_state.hpp"
#include "agents/vision/objects/look_alike.hpp"

namespace pizarra::vision {
namespace {

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

}  // namespace

std::string_view VisionAgent::State::mode() const {
  if (!finding_for.empty()) return "finding";
  if (!learning_for.empty()) return "learning";
  if (!tracker.empty()) return "tracking";
  return feed.wanted() ? "capturing" : "idle";
}

Task<void> VisionAgent::State::tell_state() {
  facts.begin_anew();
  std::vector<Datum> state;
  state.push_back(list("vision-mode"_sym, Datum::symbol(mode()), Datum::symbol(holders.connected() ? "yes" : "no")));
  told_drops = camera.drops();
  const bool open = feed.state() == CameraFeed::State::open;
  const std::string& trouble = open ? told_drops.why_corrupt : feed.trouble();
  state.push_back(list("camera-state"_sym, Datum::symbol(state_name(feed.state())), trouble));
  if (const std::optional<camera::StereoModel>& model = feed.model()) {
    state.push_back(list("camera-model"_sym, model->width, model->height, model->focal_px, model->centre_x_px,
                         model->centre_y_px, model->base_line_mm));
  }
  if (told_drops != camera::CameraDrops()) {
    state.push_back(list("camera-drops"_sym, told_drops.late, told_drops.skewed, told_drops.corrupt));
  }
  co_await facts.tell(std::move(state));
  co_await tell_streams();
  co_await tell_holders();
}

Task<void> VisionAgent::State::tell_holders() {
  std::vector<Datum> held = holders.facts();
  const auto hold = [&](const std::string& client, Datum mode) {
    held.push_back(list("vision-held"_sym, Datum::symbol(client), std::move(mode)));
  };
  if (!learning_for.empty()) hold(learning_for, "learning"_sym);
  for (const std::string& client : finding_for) hold(client, "finding"_sym);
  co_await facts.tell_held(std::move(held));
}

Task<void> VisionAgent::State::tell_objects() {
  std::vector<Datum> known = look_alikes(objects);
  for (Datum& fact : to_accept.facts()) known.push_back(std::move(fact));
  for (const auto& [object, why] : memory.troubles()) {
    known.push_back(list("objects-damaged"_sym, why.subject, Datum::symbol(why.symbol), why.sentence));
  }
  co_await facts.tell_objects(std::move(known));
}

Task<void> VisionAgent::State::tell_state_again() {
  while (true) {
    co_await sleep(context.executor, state_check);
    const bool lost = facts.lost();
    const bool news = lost || told_drops != camera.drops();
    if (news) co_await tell_state();
    if (lost) co_await tell_objects();
    co_await follow_memory();
    co_await let_dead_go();
  }
}

Task<void> VisionAgent::State::camera_changed() {
  co_await tell_state();
  if (feed.state() == CameraFeed::State::open) co_return;
  tracking_is_next = false;
  turns_changed.wake_all();
  co_await facts.unsay();
  reading = Job();
  co_await facts.unsay_tags();
}

}  // namespace pizarra::vision
