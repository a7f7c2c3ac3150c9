#include "agents/robot/robot_agent.hpp"

#include <fmt/format.h>

#include "agents/robot/arm_control.hpp"
#include "agents/robot/motion.hpp"
#include "agents/robot/reflex.hpp"
#include "agents/robot/robot_contract.hpp"
#include "agents/runtime/service.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr double max_opening_mm = 100;
constexpr std::size_t max_variables = 256;
constexpr Duration connecting_time = 5s;  // after it, requests are answered `disconnected`
constexpr Duration connecting_pause = 250ms;
constexpr Duration retry_pause = 200ms;

// Open to all; whatever else is asked for changes something, and is its commander's to ask for.
bool only_monitors(const Datum& operation) {
  return operation.is_form("get-status") || operation.is_form("monitor") || operation.is_form("finish");
}

Datum answer(bool done) { return list(done ? "true"_sym : "false"_sym); }

// A motion that was cut off by the end of the agent that ran it.
struct CutOff {
  Datum operation;
  Joints start;
};

}  // namespace

struct RobotAgent::State {
  State(AgentContext given, ArmDriver& driver, ArmModel described, const RobotOptions& options)
      : context(std::move(given)),
        name(Datum::symbol(context.name)),
        model(std::move(described)),
        room(options.room),
        facts(context, service),
        control(context, driver, model, room, options.told_per_s, facts),
        reflex(context, control),
        service(context, contract_from_text(robot_contract).value()) {}

  AgentContext context;
  const Datum name;  // the first argument of all that it tells
  const ArmModel model;
  const std::optional<Room> room;
  ArmFacts facts;
  ArmControl control;
  Reflex reflex;
  ArmVariables variables;
  double speed_percent = 100;
  std::optional<CutOff> cut_off;
  Job watch;
  Service service;  // last, because its jobs use all the others

  Task<Result<void>> run();
  Task<Result<std::vector<Fact>>> known(Datum pattern);
  Task<Result<void>> restore();
  Task<Result<void>> connect();

  Task<Result<Datum>> handle(Fact request);
  Task<Result<Datum>> answer_monitor(Datum operation);
  Task<Result<Datum>> refuse(Failure why);
  Task<Result<Datum>> get_status();
  Task<Result<Datum>> move(Datum operation, std::string client);
  Task<Result<Datum>> gripper(Datum operation, std::string client);
  Task<Result<Datum>> speed(Datum operation);
  Task<Result<Datum>> learn(Datum operation);
  Task<Result<Datum>> monitor();
  Task<Result<Datum>> finish(Datum operation);
  Task<Result<Datum>> get_control(Datum operation);

  Result<Motion> plan(const Datum& operation, const Joints& at, Joints& start);
  Task<Result<void>> tell_end(std::optional<Failure> failure, Transaction with);
};

RobotAgent::RobotAgent(AgentContext context, ArmDriver& driver, ArmModel model, RobotOptions options)
    : state_(std::make_unique<State>(std::move(context), driver, std::move(model), options)) {}

RobotAgent::~RobotAgent() = default;

Task<Result<void>> RobotAgent::run() { return state_->run(); }

Task<Result<void>> RobotAgent::State::run() {
  const Result<void> started = co_await service.start();
  if (!started) co_return started;
  const Result<void> restored = co_await restore();
  if (!restored) co_return restored;
  const Result<void> connected = co_await connect();
  if (!connected) co_return connected;
  watch = context.executor.spawn(control.keep_watch());
  reflex.begin();
  // Who stops it and who commands it is known before anybody is obeyed.
  co_await reflex.known();
  RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  co_return co_await service.serve_requests(std::move(handler));
}

Task<Result<std::vector<Fact>>> RobotAgent::State::known(Datum pattern) {
  while (true) {
    const Result<std::vector<Fact>> found = co_await context.board.facts(pattern);
    if (found || found.error().symbol != "unreachable") co_return found;
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
    const std::optional<Joints> joints = joints_from_datum(fact.datum[3]);
    const bool fits = joints && joints->size() == model.axes.size();
    if (fits) variables.insert_or_assign(std::string(fact.datum[2].text()), *joints);
  }
  const Datum speed_fact = list("robot-speed"_sym, name, any);
  const Result<std::vector<Fact>> speeds = co_await known(speed_fact);
  if (!speeds) co_return fail(speeds);
  for (const Fact& fact : *speeds) speed_percent = amount_in(fact.datum[2], 1, 100, "percent").value_or(100);
  const Datum move_fact = list("robot-move"_sym, name, any, any);
  const Result<std::vector<Fact>> moves = co_await known(move_fact);
  if (!moves) co_return fail(moves);
  for (const Fact& fact : *moves) {
    const std::optional<Joints> start = joints_from_datum(fact.datum[3]);
    const bool fits = start && start->size() == model.axes.size();
    if (fits) cut_off = CutOff{fact.datum[2], *start};
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
  const Result<void> allowed = reflex.allows(request.teller);
  if (!allowed) return refuse(allowed.error());
  if (is_motion(operation)) return move(std::move(operation), std::move(request.teller));
  if (operation.is_form("gripper")) return gripper(std::move(operation), std::move(request.teller));
  if (operation.is_form("speed")) return speed(std::move(operation));
  if (operation.is_form("learn")) return learn(std::move(operation));
  return get_control(std::move(operation));
}

Task<Result<Datum>> RobotAgent::State::answer_monitor(Datum operation) {
  if (operation.is_form("monitor")) return monitor();
  if (operation.is_form("finish")) return finish(std::move(operation));
  return get_status();
}

Task<Result<Datum>> RobotAgent::State::refuse(Failure why) { co_return fail(why); }

Task<Result<Datum>> RobotAgent::State::get_status() { co_return list(facts.action()); }

// The motion from where the arm is, or the rest of the same one that was cut off; `start` is where it began.
Result<Motion> RobotAgent::State::plan(const Datum& operation, const Joints& at, Joints& start) {
  const bool again = cut_off && cut_off->operation == operation;
  start = again ? cut_off->start : at;
  Result<Motion> motion = plan_motion(model, operation, start, variables);
  if (!motion) return motion;
  const Result<void> inside = check_room(model, room, start, motion->waypoints);
  if (!inside) return fail(inside);
  // Whatever moves now, an earlier motion is not gone on with any more.
  cut_off.reset();
  if (!again) return motion;
  return rest_of(std::move(*motion), start, at);
}

Task<Result<Datum>> RobotAgent::State::move(Datum operation, std::string client) {
  const Result<InHand> in_hand = control.take_in_hand(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<ArmReading> reading = co_await control.read();
  if (!reading) co_return fail(reading);
  Joints start;
  Result<Motion> motion = plan(operation, reading->joints, start);
  if (!motion) co_return fail(motion);
  Transaction end;
  end.retract(list("robot-move"_sym, name, "?"_sym, "?"_sym));
  if (motion->waypoints.empty()) {
    facts.set_arm("idle", write(operation));
    const Result<void> told = co_await facts.tell_surely(std::move(end));
    if (!told) co_return fail(told);
    co_return answer(!motion->at_limit);
  }
  facts.set_arm("moving", write(operation));
  // Awaited before anything moves, a round trip of the board: had the arm begun and this agent died before the board
  // had it, its successor would be asked for the same and add it to what was moved already.
  Transaction begin;
  begin.tell(list("robot-move"_sym, name, operation, joints_to_datum(start)));
  const Result<void> begun = co_await facts.tell_surely(std::move(begin));
  if (!begun) co_return fail(begun);
  const double speed_part = speed_percent / 100;
  const Joints at = reading->joints;
  const Job watching = context.executor.spawn(reflex.watch_motion(client, service.presence()));
  const Result<void> moved = co_await control.follow(at, std::move(motion->waypoints), speed_part);
  std::optional<Failure> failure;
  if (!moved) failure = moved.error();
  const Result<void> told = co_await tell_end(failure, std::move(end));
  if (!moved) co_return fail(moved);
  if (!told) co_return fail(told);
  co_return answer(true);
}

// How a motion ended, with the arm's last reading, before its reply.
Task<Result<void>> RobotAgent::State::tell_end(std::optional<Failure> failure, Transaction with) {
  if (!failure) facts.set_arm("idle");
  if (failure && control.connected()) {
    const bool stopped = control.was_stopped() || failure->symbol == "stopped";
    facts.set_arm(failure->symbol == "fault" ? "fault" : stopped ? "stopped" : "idle");
  }
  return facts.tell_surely(std::move(with));
}

Task<Result<Datum>> RobotAgent::State::gripper(Datum operation, std::string client) {
  const Result<double> opening = amount_in(operation[1], 0, max_opening_mm, "mm");
  if (!opening) co_return fail(opening);
  const Result<InHand> in_hand = control.take_in_hand(operation);
  if (!in_hand) co_return fail(in_hand);
  cut_off.reset();
  facts.set_arm("moving", write(operation));
  Transaction begin;
  begin.retract(list("robot-move"_sym, name, "?"_sym, "?"_sym));
  const Result<void> begun = co_await facts.tell_surely(std::move(begin));
  if (!begun) co_return fail(begun);
  const double opening_mm = *opening;
  const Job watching = context.executor.spawn(reflex.watch_motion(client, service.presence()));
  const Result<void> moved = co_await control.grip(opening_mm);
  std::optional<Failure> failure;
  if (!moved) failure = moved.error();
  Transaction nothing_else;
  const Result<void> told = co_await tell_end(failure, std::move(nothing_else));
  if (!moved) co_return fail(moved);
  if (!told) co_return fail(told);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::speed(Datum operation) {
  const Result<double> percent = amount_in(operation[1], 1, 100, "percent");
  if (!percent) co_return fail(percent);
  const Datum fact = list("robot-speed"_sym, name, *percent);
  const Result<Revision> told = co_await context.board.tell(fact);
  if (!told) co_return fail(told);
  speed_percent = *percent;
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::learn(Datum operation) {
  const std::string variable(operation[1].text());
  if (!variables.contains(variable) && variables.size() >= max_variables) {
    co_return fail("out-of-range", fmt::format("{} variables are learned already", max_variables), operation[1]);
  }
  const Result<ArmReading> reading = co_await control.read();
  if (!reading) co_return fail(reading);
  const Datum fact = list("robot-variable"_sym, name, operation[1], joints_to_datum(reading->joints));
  const Result<Revision> told = co_await context.board.tell(fact);
  if (!told) co_return fail(told);
  variables.insert_or_assign(variable, reading->joints);
  co_return answer(true);
}

Task<Result<Datum>> RobotAgent::State::monitor() {
  const Result<ArmReading> reading = co_await control.read();
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
  const Result<InHand> in_hand = control.take_in_hand(operation);
  if (!in_hand) co_return fail(in_hand);
  const Result<void> taken = co_await control.get_control();
  if (!taken) co_return fail(taken);
  const Result<void> told = co_await facts.tell_surely();
  if (!told) co_return fail(told);
  co_return answer(true);
}

}  // namespace pizarra
