#include "agents/vision/agent/state_teller.hpp"

#include <algorithm>

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

}  // namespace

std::string_view StateTeller::mode() const {
  if (holders_.finding()) return "finding";
  if (holders_.learning()) return "learning";
  if (!tracker_.empty()) return "tracking";
  return feed_.wanted() ? "capturing" : "idle";
}

Task<void> StateTeller::tell() {
  facts_.begin_anew();
  std::vector<Datum> state;
  state.push_back(list("vision-mode"_sym, Datum::symbol(mode()), Datum::symbol(holders_.connected() ? "yes" : "no")));
  told_drops_ = camera_.drops();
  const bool open = feed_.state() == CameraFeed::State::open;
  const std::string& trouble = open ? told_drops_.why_corrupt : feed_.trouble();
  state.push_back(list("camera-state"_sym, Datum::symbol(state_name(feed_.state())), trouble));
  if (const std::optional<camera::StereoModel>& model = feed_.model()) {
    state.push_back(list("camera-model"_sym, model->width, model->height, model->focal_px, model->centre_x_px,
                         model->centre_y_px, model->base_line_mm));
  }
  if (told_drops_ != camera::CameraDrops()) {
    state.push_back(list("camera-drops"_sym, told_drops_.late, told_drops_.skewed, told_drops_.corrupt));
  }
  co_await facts_.tell(std::move(state));
  co_await tell_streams();
  co_await tell_holders();
}

// Streams have the agent's name already, so these facts do not begin with it.
Task<void> StateTeller::tell_streams() {
  Transaction transaction;
  for (const Datum& fact : pictures_.facts()) transaction.tell(fact, {}, facts_.presence());
  co_await facts_.transact(std::move(transaction));
}

Task<void> StateTeller::tell_holders() {
  std::vector<Datum> held = holders_.facts();
  Transaction transaction;
  for (const Datum& fact : told_held_) {
    const bool stays = std::ranges::find(held, fact) != held.end();
    if (!stays) facts_.retract(transaction, fact);
  }
  facts_.add(transaction, held);
  told_held_ = std::move(held);
  co_await facts_.transact(std::move(transaction));
}

}  // namespace pizarra::vision
