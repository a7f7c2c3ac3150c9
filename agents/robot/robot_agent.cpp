#include "agents/robot/robot_agent.hpp"

#include <cmath>
#include <fmt/format.h>

#include "agents/robot/arm_control.hpp"
#include "agents/robot/holds.hpp"
#include "agents/robot/jog.hpp"
#include "agents/robot/motion.hpp"
#include "agents/robot/reflex.hpp"
#include "agents/robot/robot_contract.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/away.hpp"
#include "drivers/arm/placement.hpp"
#include "lisp/writer.hpp"

namespace pizarra::robot {

namespace {

constexpr double max_opening_mm = 100;
constexpr std::size_t max_variables = 256;
constexpr Duration connecting_time = 5s;  // after it, requests are answered `disconnected`
constexpr Duration connecting_pause = 250ms;

// Open to all; whatever else is asked for changes something, and is its commander's to ask for.
bool only_monitors(const Datum& operation) {
  return operation.is_form("get-status") || operation.is_form("monitor") || operation.is_form("finish");
}

Datum answer(bool done) { return list(done ? "true"_sym : "false"_sym); }

// What a reply says, as a handler does.
Result<Datum> result_of(const Datum& reply) {
  if (reply.is_form("fail")) return fail(failure_from_datum(reply));
  return Datum::list({reply.items().begin() + 1, reply.items().end()});
}

// The newest motion of an earlier life, and what its request is answered.
struct EarlierMotion {
  Datum request;
  Result<Datum> answer;
};

runtime::Contract contract_in(const std::string& context) {
  runtime::Contract contract = runtime::contract_from_text(robot_contract).value();
  contract.context = context;
  return contract;
}

}  // namespace

struct RobotAgent::State {
  State(runtime::AgentContext given, arm::ArmDriver& driver, arm::ArmModel described, const RobotOptions& options)
      : context(std::move(given)),
        name(Datum::symbol(context.name)),
        model(std::move(described)),
        room(options.room),
        facts(context, service),
        control(context, driver, model, room, options.told_per_s, facts),
        reflex(context, control),
        holds(context, control),
        service(context, contract_in(options.context)) {}

  runtime::AgentContext context;
  const Datum name;  // the first argument of all that it tells
  const arm::ArmModel model;
  const std::optional<Room> room;
  ArmFacts facts;
  ArmControl control;
  Reflex reflex;
  Holds holds;
  ArmVariables variables;
  double speed_percent = 100;
  std::optional<EarlierMotion> earlier;
  Job watch;
  runtime::Service service;  // last, because its jobs use all the others

  Task<Result<void>> run();
  Task<Result<std::vector<Fact>>> known(Datum pattern);
  Task<Result<void>> restore();
  Task<void> tell_properties();
  Task<Result<void>> connect();

  Task<Result<Datum>> handle(Fact request);
  Task<Result<Datum>> answer_monitor(Datum operation);
  Task<Result<Datum>> answer_with(Result<Datum> known);
  Task<Result<Datum>> get_status();
  Task<Result<Datum>> move(Fact request);
  Task<Result<Datum>> jog(Fact request);
  Task<Result<void>> follow_while_held(std::string client, Duration deadline, arm::Joints from,
                                       std::vector<arm::Joints> waypoints);
  Task<Result<Datum>> gripper(Fact request);
  Task<Result<Datum>> carry_out(Fact request, Task<Result<void>> motion);
  Task<Result<Datum>> speed(Datum operation);
  Task<Result<Datum>> learn(Datum operation);
  Task<Result<Datum>> monitor();
  Task<Result<Datum>> finish(Datum operation);
  Task<Result<Datum>> get_control(Datum operation);
  Task<Result<Datum>> release_control(Fact request);

  Datum released_fact(const Datum& client) const { return list("robot-released"_sym, name, client); }
  Datum motion_fact(const Datum& request, const Datum& outcome) const {
    return list("robot-motion"_sym, name, request, outcome);
  }
};

RobotAgent::RobotAgent(runtime::AgentContext context, arm::ArmDriver& driver, arm::ArmModel model, RobotOptions options)
    : state_(std::make_unique<State>(std::move(context), driver, std::move(model), options)) {}

RobotAgent::~RobotAgent() = default;

Task<Result<void>> RobotAgent::run() { return state_->run(); }

Task<Result<void>> RobotAgent::State::run() {
  // At once: what an earlier life of this agent began may go on, and its name is taken for as long as its lease. One
  // that is not there yet is waited for below.
  [[maybe_unused]] const Result<arm::ArmReading> found = co_await control.find();
  const Result<void> started = co_await service.start();
  if (!started) co_return started;
  const Result<void> restored = co_await restore();
  if (!restored) co_return restored;
  co_await tell_properties();
  const Result<void> connected = co_await connect();
  if (!connected) co_return connected;
  watch = context.executor.spawn(control.keep_watch());
  reflex.begin();
  holds.begin();
  // The agent knows who stops it and who commands it before it obeys anybody.
  co_await reflex.known();
  runtime::RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  co_return co_await service.serve_requests(std::move(handler));
}

Task<Result<std::vector<Fact>>> RobotAgent::State::known(Datum pattern) {
  while (true) {
    const Result<std::vector<Fact>> found = co_await context.board.facts(pattern);
    if (found || !is_away(found.error())) co_return found;
    co_await sleep(context.executor, retry_pause);
  }
}

// Clients find it among others of its kind by these properties. Where the board refuses them, as when its disk is full,
// it serves all the same.
Task<void> RobotAgent::State::tell_properties() {
  Transaction properties;
  properties.tell(
      list("property"_sym, name, "reach"_sym, static_cast<std::int64_t>(std::lround(arm::longest_reach_mm(model)))));
  properties.tell(list("property"_sym, name, "axes"_sym, static_cast<std::int64_t>(model.axes.size())));
  properties.tell(list("property"_sym, name, "arm"_sym, Datum::symbol(model.type)));
  while (true) {
    const Result<Revision> told = co_await context.board.transact(properties);
    if (told || !is_away(told.error())) co_return;
    co_await sleep(context.executor, retry_pause);
  }
}

// What an earlier life of this agent knew. A fact that somebody else mangled is left alone.
Task<Result<void>> RobotAgent::State::restore() {
  const Datum any = "?"_sym;
  const Datum variable = list("robot-variable"_sym, name, any, any);
  const Result<std::vector<Fact>> learned = co_await known(variable);
  if (!learned) co_return fail(learned);
  for (const Fact& fact : *learned) {
    const std::optional<arm::Joints> joints = joints_from_datum(fact.datum[3]);
    const bool fits = joints && joints->size() == model.axes.size();
    if (fits) variables.insert_or_assign(std::string(fact.datum[2].text()), *joints);
  }
  const Datum speed_fact = list("robot-speed"_sym, name, any);
  const Result<std::vector<Fact>> speeds = co_await known(speed_fact);
  if (!speeds) co_return fail(speeds);
  for (const Fact& fact : *speeds) speed_percent = amount_in(fact.datum[2], 1, 100, "percent").value_or(100);
  const Datum released = released_fact(any);
  const Result<std::vector<Fact>> releases = co_await known(released);
  if (!releases) co_return fail(releases);
  for (const Fact& fact : *releases) control.set_released(std::string(fact.datum[2].text()));
  const Datum any_motion = motion_fact(any, any);
  const Result<std::vector<Fact>> motions = co_await known(any_motion);
  if (!motions) co_return fail(motions);
  for (const Fact& fact : *motions) {
    const Datum& outcome = fact.datum[3];
    const bool ended = outcome.is_form("ok") || outcome.is_form("fail");
    earlier.emplace(fact.datum[2],
                    fail("stopped", "the robot agent was restarted during this motion, and stopped the arm"));
    if (ended) earlier->answer = result_of(outcome);
  }
  co_return {};
}

// Waits a while for a controller that starts together with this agent.
Task<Result<void>> RobotAgent::State::connect() {
  const Time deadline = context.executor.now() + connecting_time;
  Result<void> connected = co_await control.connect();
  while (!connected) {
    if (connected.error().symbol == "unknown-arm") co_return connected;
    if (context.executor.now() >= deadline) break;
    co_await sleep(context.executor, connecting_pause);
    connected = co_await control.connect();
  }
  if (!connected) control.lose(connected.error());
  co_return co_await facts.tell_surely();
}

Task<Result<Datum>> RobotAgent::State::handle(Fact request) {
  Datum operation = request.datum[3];
  if (only_monitors(operation)) return answer_monitor(std::move(operation));
  if (earlier && earlier->request == request.datum[1]) return answer_with(earlier->answer);
  const Result<void> allowed = reflex.allows(request.teller);
  if (!allowed) return answer_with(fail(allowed));
  if (is_motion(operation)) return move(std::move(request));
  if (operation.is_form("jog")) return jog(std::move(request));
  if (operation.is_form("gripper")) return gripper(std::move(request));
  if (operation.is_form("speed")) return speed(std::move(operation));
  if (operation.is_form("learn")) return learn(std::move(operation));
  if (operation.is_form("release-control")) return release_control(std::move(request));
  return get_control(std::move(operation));
}

Task<Result<Datum>> RobotAgent::State::answer_monitor(Datum operation) {
  if (operation.is_form("monitor")) return monitor();
  if (operation.is_form("finish")) return finish(std::move(operation));
  return get_status();
}

Task<Result<Datum>> RobotAgent::State::answer_with(Result<Datum> known) { co_return known; }

Task<Result<Datum>> RobotAgent::State::get_status() { co_return list(facts.action()); }

Task<Result<Datum>> RobotAgent::State::move(Fact request) {
  const Datum operation = request.datum[3];
  const Result<InHand> in_hand = control.take_in_hand(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<arm::ArmReading> reading = co_await control.read();
  if (!reading) co_return fail(reading);
  const arm::Joints at = reading->joints;
  Result<Motion> motion = plan_motion(model, operation, at, variables);
  if (!motion) co_return fail(motion);
  const Result<void> inside = check_room(model, room, at, motion->waypoints);
  if (!inside) co_return fail(inside);
  if (motion->waypoints.empty()) {
    facts.set_arm("idle", write(operation));
    const Result<void> told = co_await facts.tell_surely();
    if (!told) co_return fail(told);
    co_return answer(!motion->at_limit);
  }
  const double speed_part = speed_percent / 100;
  Task<Result<void>> following = control.follow(at, std::move(motion->waypoints), speed_part);
  co_return co_await carry_out(std::move(request), std::move(following));
}

Task<Result<Datum>> RobotAgent::State::jog(Fact request) {
  const Datum operation = request.datum[3];
  const double least_ms = std::chrono::duration<double, std::milli>(Holds::least_deadline).count();
  const double longest_ms = std::chrono::duration<double, std::milli>(Holds::longest_deadline).count();
  const Result<double> given_ms = amount_in(operation[2], least_ms, longest_ms, "ms");
  if (!given_ms) co_return fail(given_ms);
  const auto deadline = std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(*given_ms));
  const Result<InHand> in_hand = control.take_in_hand(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> held = co_await holds.await(request.teller, deadline);
  if (!held) co_return fail(held);
  const Result<arm::ArmReading> reading = co_await control.read();
  if (!reading) co_return fail(reading);
  const arm::Joints at = reading->joints;
  Result<Motion> motion = plan_jog(model, room, operation[1].text(), at);
  if (!motion) co_return fail(motion);
  if (motion->at_limit) co_return answer(false);
  Task<Result<void>> following = follow_while_held(request.teller, deadline, at, std::move(motion->waypoints));
  co_return co_await carry_out(std::move(request), std::move(following));
}

// To let go is how a jog ends.
Task<Result<void>> RobotAgent::State::follow_while_held(std::string client, Duration deadline, arm::Joints from,
                                                        std::vector<arm::Joints> waypoints) {
  const Result<void> held = co_await holds.await(client, deadline);
  if (!held) co_return held;
  const double speed_part = std::min(speed_percent / 100, jog_speed(model, from, waypoints, deadline));
  const Holds::Watching watching(holds, client, deadline);
  Result<void> moved = co_await control.follow(from, std::move(waypoints), speed_part);
  const bool released = !moved && moved.error().symbol == Holds::released;
  if (released) co_return Result<void>();
  co_return moved;
}

Task<Result<Datum>> RobotAgent::State::gripper(Fact request) {
  const Datum operation = request.datum[3];
  const Result<double> opening_mm = amount_in(operation[1], 0, max_opening_mm, "mm");
  if (!opening_mm) co_return fail(opening_mm);
  const Result<InHand> in_hand = control.take_in_hand(operation);
  if (!in_hand) co_return fail(in_hand);
  Task<Result<void>> gripping = control.grip(*opening_mm);
  co_return co_await carry_out(std::move(request), std::move(gripping));
}

// The board has it before anything moves, a round trip, and how it ended before it is answered: whenever this agent
// dies, its successor knows what to answer, and moves nothing twice.
Task<Result<Datum>> RobotAgent::State::carry_out(Fact request, Task<Result<void>> motion) {
  const Datum& id = request.datum[1];
  facts.set_arm("moving", write(request.datum[3]));
  Transaction begin;
  begin.tell(motion_fact(id, Datum()));
  const Result<void> begun = co_await facts.tell_surely(std::move(begin));
  if (!begun) {
    facts.set_arm("idle");
    co_return fail(begun);
  }
  const Reflex::Watching watching(reflex, request.teller, service.presence());
  // Anything may have been said meanwhile.
  Result<void> moved = reflex.allows(request.teller);
  if (moved) moved = co_await motion;
  if (moved) facts.set_arm("idle");
  if (!moved && control.connected()) {
    const bool stopped = control.was_stopped() || moved.error().symbol == "stopped";
    facts.set_arm(moved.error().symbol == "fault" ? "fault" : stopped ? "stopped" : "idle");
  }
  Transaction end;
  end.tell(motion_fact(id, moved ? list("ok"_sym, "true"_sym) : failure_to_datum(moved.error())));
  const Result<void> told = co_await facts.tell_surely(std::move(end));
  if (!moved) co_return fail(moved);
  if (!told) co_return fail(told);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::speed(Datum operation) {
  const Result<double> percent = amount_in(operation[1], 1, 100, "percent");
  if (!percent) co_return fail(percent);
  const Datum fact = list("robot-speed"_sym, name, *percent);
  const Result<Revision> told = if_it_stands(co_await context.board.tell(fact));
  if (!told) co_return fail(told);
  speed_percent = *percent;
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::learn(Datum operation) {
  const std::string variable(operation[1].text());
  if (!variables.contains(variable) && variables.size() >= max_variables) {
    co_return fail("out-of-range", fmt::format("{} variables are learned already", max_variables), operation[1]);
  }
  const Result<arm::ArmReading> reading = co_await control.read();
  if (!reading) co_return fail(reading);
  const Datum fact = list("robot-variable"_sym, name, operation[1], joints_to_datum(reading->joints));
  const Result<Revision> told = if_it_stands(co_await context.board.tell(fact));
  if (!told) co_return fail(told);
  variables.insert_or_assign(variable, reading->joints);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::monitor() {
  const Result<arm::ArmReading> reading = co_await control.read();
  if (!reading) co_return fail(reading);
  std::vector<Datum> numbers = pose_numbers(model, reading->joints);
  const std::vector<Datum> joints = joint_numbers(reading->joints);
  numbers.insert(numbers.end(), joints.begin(), joints.end());
  co_return Datum::list(std::move(numbers));
}

Task<Result<Datum>> RobotAgent::State::finish(Datum operation) {
  if (operation[1].is_symbol("report")) co_return answer(!control.running());
  if (!operation[1].is_symbol("stop")) {
    co_return fail("wrong-direction", "finish takes report or stop", operation[1]);
  }
  const Result<void> stopped = co_await control.stop();
  if (!stopped) co_return fail(stopped);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::get_control(Datum operation) {
  const Result<InHand> in_hand = control.occupy(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> taken = co_await control.get_control();
  if (!taken) co_return fail(taken);
  Transaction taking;
  taking.retract(released_fact("?"_sym));
  const Result<void> told = co_await facts.tell_surely(std::move(taking));
  if (!told) co_return fail(told);
  co_return answer(true);
}

// The board has it before the servos go off: a successor of this agent leaves them off.
Task<Result<Datum>> RobotAgent::State::release_control(Fact request) {
  const Result<InHand> in_hand = control.occupy(request.datum[3]);
  if (!in_hand) co_return fail(in_hand);
  Transaction releasing;
  releasing.tell(released_fact(Datum::symbol(request.teller)));
  const Result<void> kept = co_await facts.tell_surely(std::move(releasing));
  if (!kept) co_return fail(kept);
  control.set_released(request.teller);
  const Result<void> released = co_await control.release_control();
  if (!released) co_return fail(released);
  const Result<void> told = co_await facts.tell_surely();
  if (!told) co_return fail(told);
  co_return answer(true);
}

}  // namespace pizarra::robot
