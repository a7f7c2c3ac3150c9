#include "agents/coordinator/perceive/head.hpp"

#include <cmath>
#include <fmt/format.h>

#include "agents/coordinator/retried_commit.hpp"
#include "agents/runtime/stop_fact.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration turn_reply_timeout = 5s;
// A whole turn at the slowest speed that makes sense; who set a slower one waits in vain.
constexpr Duration turning_time = 20s;
constexpr Duration turn_look_pause = 50ms;
constexpr double near_deg = 0.5;

}  // namespace

runtime::Role head_role() { return {"head", "pan-tilt", "heads", "pan-tilt"}; }

Task<Result<void>> Head::may_turn() {
  const runtime::Holder& holder = roles_.holder("head");
  const Datum who = Datum::symbol(holder.server);
  if (!holder.is_present()) co_return fail("head-away", "the pan-tilt agent is not there", who);
  if (!surroundings_.scene().head()) co_return fail("head-away", "nobody knows where the head looks", who);
  const Datum of_stops = runtime::any_stop();
  const std::vector<Fact> stops = co_await facts_now(context_.board, context_.executor, of_stops);
  if (!stops.empty()) {
    const Datum& stop = stops.front().datum;
    co_return fail("halted", runtime::stop_in_words(stop), stop);
  }
  const Datum of_target = list("looking-at"_sym, "?"_sym);
  const std::vector<Fact> targets = co_await facts_now(context_.board, context_.executor, of_target);
  if (targets.empty()) co_return Result<void>();
  const Datum& target = targets.front().datum;
  co_return fail("head-taken", fmt::format("somebody has it keep {} in view", target[1].text()), target);
}

Task<Result<HeadRange>> Head::free_range() {
  const Result<void> free = co_await may_turn();
  if (!free) co_return fail(free);
  const Datum of_unit = list("pan-tilt-unit"_sym, "?"_sym, "?"_sym);
  const std::vector<Fact> units = co_await facts_now(context_.board, context_.executor, of_unit);
  if (units.empty()) co_return fail("head-away", "nobody tells how far the head turns");
  co_return head_range_from_fact(units.front().datum);
}

Task<Result<void>> Head::turn(HeadTurn turn) {
  const Result<void> free = co_await may_turn();
  if (!free) co_return free;
  const Datum pan = list("set-pan-pos"_sym, turn.pan_deg);
  const Datum tilt = list("set-tilt-pos"_sym, turn.tilt_deg);
  const Result<Datum> panning = co_await caller_.call(roles_.player("head"), pan, turn_reply_timeout);
  if (!panning) co_return fail(panning);
  const Result<Datum> tilting = co_await caller_.call(roles_.player("head"), tilt, turn_reply_timeout);
  if (!tilting) co_return fail(tilting);
  const bool stands = co_await stands_at(turn);
  if (stands) co_return Result<void>();
  co_return fail("head-away", "the head does not come to where it was turned", list(turn.pan_deg, turn.tilt_deg));
}

Task<bool> Head::stands_at(HeadTurn turn) {
  const Time deadline = context_.executor.now() + turning_time;
  while (context_.executor.now() < deadline) {
    const std::optional<HeadTurn>& now = surroundings_.scene().head();
    const bool there = now && std::hypot(now->pan_deg - turn.pan_deg, now->tilt_deg - turn.tilt_deg) < near_deg;
    if (there) co_return true;
    co_await sleep(context_.executor, turn_look_pause);
  }
  co_return false;
}

}  // namespace pizarra::coordinator
