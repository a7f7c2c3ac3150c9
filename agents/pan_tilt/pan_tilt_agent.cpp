#include "agents/pan_tilt/pan_tilt_agent.hpp"

#include <cmath>
#include <fmt/format.h>

#include "agents/pan_tilt/gaze.hpp"
#include "agents/pan_tilt/head_control.hpp"
#include "agents/pan_tilt/pan_tilt_contract.hpp"
#include "agents/runtime/declared.hpp"
#include "agents/runtime/follow.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/away.hpp"

namespace pizarra::pan_tilt {

namespace {

constexpr Duration opening_time = 10s;
constexpr Duration settling_time = 30s;
// An object this near the middle of the image is in view; the head rests meanwhile, so that what is seen can be placed.
constexpr double in_view_deg = 5;

Datum done() { return list("true"_sym); }

Datum places_of(const std::string& name) {
  return list("place"_sym, Datum::symbol(name), "?x"_sym, "?y"_sym, "?z"_sym, "?frame"_sym);
}

std::array<double, 3> point_of(const Datum& place) { return {place[2].number(), place[3].number(), place[4].number()}; }

}  // namespace

struct PanTiltAgent::State {
  State(runtime::AgentContext given, ptu::PanTiltDriver& driver, forms::CameraPose the_mount)
      : context(std::move(given)),
        mount(the_mount),
        service(context, runtime::contract_from_text(pan_tilt_contract).value()),
        facts(context, service),
        head(context, driver, facts) {}

  runtime::AgentContext context;
  forms::CameraPose mount;
  runtime::Service service;
  HeadFacts facts;
  HeadControl head;
  Job following;
  Job watching;

  Task<Result<void>> run();
  Task<Result<void>> recall_speeds();
  Task<Result<Datum>> handle(Datum operation);
  Task<Result<Datum>> turn(Datum operation);
  Task<Result<Datum>> set_speed(bool pan, Datum percent);
  Task<Result<Datum>> reset(std::string_view which);
  Task<Result<Datum>> look_at(std::string name);
  Task<Result<Datum>> look_ahead();
  Task<Result<Datum>> monitor();
  Task<Result<void>> aim(std::array<double, 3> point_mm, double tolerance_deg);
  Task<void> follow(std::string name);
  Task<void> aim_anew(Change change);
  Task<void> stop_following();
};

PanTiltAgent::PanTiltAgent(runtime::AgentContext context, ptu::PanTiltDriver& driver, forms::CameraPose mount)
    : state_(std::make_unique<State>(std::move(context), driver, mount)) {}

PanTiltAgent::~PanTiltAgent() = default;

Task<Result<void>> PanTiltAgent::run() { return state_->run(); }

Task<Result<void>> PanTiltAgent::State::run() {
  const Result<void> started = co_await service.start();
  if (!started) co_return started;
  const Result<void> recalled = co_await recall_speeds();
  if (!recalled) co_return recalled;
  facts.set_state("connecting", "");
  watching = context.executor.spawn(head.run());
  runtime::Handler handler = [this](Datum operation) { return handle(std::move(operation)); };
  co_return co_await service.serve(std::move(handler));
}

Task<Result<void>> PanTiltAgent::State::recall_speeds() {
  const Datum pattern = list("head-speed"_sym, "?"_sym, "?"_sym);
  Result<std::vector<Fact>> found = co_await context.board.facts(pattern);
  while (!found && is_away(found.error())) {
    co_await sleep(context.executor, retry_pause);
    found = co_await context.board.facts(pattern);
  }
  if (!found) co_return fail(found);
  for (const Fact& fact : *found) {
    const HeadSpeeds speeds{fact.datum[1].number(), fact.datum[2].number()};
    const bool sound = std::min(speeds.pan_percent, speeds.tilt_percent) >= 0 &&
                       std::max(speeds.pan_percent, speeds.tilt_percent) <= 100;
    if (sound) head.begin_with(speeds);
  }
  co_return Result<void>();
}

Task<Result<Datum>> PanTiltAgent::State::handle(Datum operation) {
  const std::string_view name = operation.head();
  if (name == "set-pan-speed") return set_speed(true, operation[1]);
  if (name == "set-tilt-speed") return set_speed(false, operation[1]);
  if (name == "look-at") return look_at(std::string(operation[1].text()));
  if (name == "look-ahead") return look_ahead();
  if (name == "monitor") return monitor();
  if (name == "reset-all" || name == "reset-pan" || name == "reset-tilt") return reset(name.substr(6));
  return turn(std::move(operation));
}

// The operations that put the head somewhere, open and close it.
Task<Result<Datum>> PanTiltAgent::State::turn(Datum operation) {
  const std::string_view name = operation.head();
  if (name == "pt-init") {
    const Time deadline = context.executor.now() + opening_time;
    const Result<void> open = co_await head.open(deadline);
    if (!open) co_return fail(open);
    co_return done();
  }
  co_await stop_following();
  if (name == "pt-close") {
    const Result<void> closed = co_await head.close();
    if (!closed) co_return fail(closed);
    co_return done();
  }
  double deg = operation[1].number();
  const bool pan = name.starts_with("set-pan");
  if (name.find("-rel-") != std::string_view::npos) {
    const Result<ptu::PanTiltReading> reading = co_await head.read();
    if (!reading) co_return fail(reading);
    deg += pan ? reading->pan_deg : reading->tilt_deg;
  }
  HeadMove move;
  (pan ? move.pan_deg : move.tilt_deg) = deg;
  const Result<void> moving = co_await head.move(move);
  if (!moving) co_return fail(moving);
  co_return done();
}

Task<Result<Datum>> PanTiltAgent::State::set_speed(bool pan, Datum percent) {
  if (percent.number() < 0 || percent.number() > 100) {
    co_return fail("out-of-range", "a speed is 0 to 100 percent", percent);
  }
  HeadSpeeds speeds = head.speeds();
  (pan ? speeds.pan_percent : speeds.tilt_percent) = percent.number();
  const Result<void> set = co_await head.set_speeds(speeds);
  if (!set) co_return fail(set);
  const Datum fact = list("head-speed"_sym, speeds.pan_percent, speeds.tilt_percent);
  const Result<Revision> told = if_it_stands(co_await context.board.tell(fact));
  if (!told) co_return fail(told);
  co_return done();
}

Task<Result<Datum>> PanTiltAgent::State::reset(std::string_view which) {
  std::optional<ptu::PanTiltAxis> axis;
  if (which == "pan") axis = ptu::PanTiltAxis::pan;
  if (which == "tilt") axis = ptu::PanTiltAxis::tilt;
  co_await stop_following();
  const Result<void> reset = co_await head.reset(axis);
  if (!reset) co_return fail(reset);
  co_return done();
}

Task<Result<Datum>> PanTiltAgent::State::look_at(std::string name) {
  // The relation is the coordinator's; before it has come, nothing is seen anywhere.
  const Result<std::vector<Fact>> places = co_await runtime::facts_if_declared(context.board, places_of(name));
  const bool known = places && !places->empty();
  if (!known) {
    co_return fail("unknown-place", fmt::format("nobody tells where {} is", name), Datum::symbol(name));
  }
  co_await stop_following();
  const std::array<double, 3> point_mm = point_of(places->front().datum);
  const Result<void> aimed = co_await aim(point_mm, 0);
  if (!aimed) co_return fail(aimed);
  facts.set_target(name);
  following = context.executor.spawn(follow(std::move(name)));
  const Result<void> told = co_await facts.tell();
  if (!told) co_return fail(told);
  co_return done();
}

Task<Result<Datum>> PanTiltAgent::State::look_ahead() {
  co_await stop_following();
  const HeadMove ahead{0.0, 0.0};
  const Result<void> moving = co_await head.move(ahead);
  if (!moving) co_return fail(moving);
  co_return done();
}

Task<Result<Datum>> PanTiltAgent::State::monitor() {
  const Result<ptu::PanTiltReading> reading = co_await head.read();
  if (!reading) co_return fail(reading);
  co_return list(reading->pan_deg, reading->tilt_deg, reading->moving ? "moving"_sym : "still"_sym);
}

// Turns towards the point, as far as the unit can, where it is further from the middle of the image than that.
Task<Result<void>> PanTiltAgent::State::aim(std::array<double, 3> point_mm, double tolerance_deg) {
  const Result<ptu::PanTiltReading> reading = co_await head.read();
  if (!reading) co_return fail(reading);
  const Gaze gaze = gaze_at(mount, point_mm);
  const double off_deg =
      std::max(std::abs(gaze.pan_deg - reading->pan_deg), std::abs(gaze.tilt_deg - reading->tilt_deg));
  if (off_deg <= tolerance_deg) co_return Result<void>();
  const HeadMove wanted{gaze.pan_deg, gaze.tilt_deg};
  const HeadMove move = head.within_range(wanted);
  const Result<void> moving = co_await head.move(move);
  co_return moving;
}

Task<void> PanTiltAgent::State::follow(std::string name) {
  return runtime::follow(context, places_of(name), [this](Change change) { return aim_anew(std::move(change)); });
}

// An aim that fails, the unit being away, is taken again with the next place.
Task<void> PanTiltAgent::State::aim_anew(Change change) {
  if (change.added.empty()) co_return;
  const Time settled_by = context.executor.now() + settling_time;
  co_await head.until_still(settled_by);
  const std::array<double, 3> point_mm = point_of(change.added.back().facts.front().datum);
  const Result<void> aimed = co_await aim(point_mm, in_view_deg);
  static_cast<void>(aimed);
}

Task<void> PanTiltAgent::State::stop_following() {
  following = Job();
  facts.set_target(std::nullopt);
  const Result<void> told = co_await facts.tell();
  static_cast<void>(told);
}

}  // namespace pizarra::pan_tilt
